#include "lsp/outline.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

using nlohmann::json;

std::string brief(const json& symbols) {
  std::string all;
  for (const json& one : symbols) {
    all += one.at("name").get<std::string>();
    const std::string detail = one.at("detail");
    if (!detail.empty()) all += "/" + detail;
    if (!one.at("children").empty()) all += "(" + brief(one.at("children")) + ")";
    all += "|";
  }
  return all;
}

std::string outline(const std::string& text) {
  return brief(outline_of({"x.md", text}, Units::utf16));
}

std::string lines_of(const json& range) {
  const auto line = [&](const char* end) {
    return std::to_string(range.at(end).at("line").get<int>()) + ":" +
           std::to_string(range.at(end).at("character").get<int>());
  };
  return line("start") + "-" + line("end");
}

TEST(Outline, NestsHeadingsByTheirLevels) {
  EXPECT_EQ(outline("# A\n## B\n### C\n## D\n# E\n"), "A(B(C|)|D|)|E|");
  EXPECT_EQ(outline("### Deep\n## Less\n#### Skips\n"), "Deep|Less(Skips|)|");
}

TEST(Outline, KnowsAHeadingFromOtherLines) {
  EXPECT_EQ(outline("#tag\n####### seven\ntext # A\n## A\n"), "A|");
  EXPECT_EQ(outline("```text\n# no heading\n```\n"), "");
}

TEST(Outline, BeginsBehindTheFrontMatter) {
  EXPECT_EQ(outline("---\n# a comment\ntitle: T\n---\n# A\n"), "A|");
  EXPECT_EQ(outline("---\n# not closed yet\n"), "not closed yet|");
}

TEST(Outline, PutsWhatStandsBelowAHeadingThere) {
  EXPECT_EQ(outline("```lab simlab\n{\"title\": \"First\"}\n```\n## A\n"
                    "```cpp file=examples/x.cpp optimize\nint main() {}\n```\n### B\n"
                    "```figure\n{\"alt\": \"A swing.\"}\n```\n"),
            "First/lab|A(examples/x.cpp/program|B(A swing./figure|)|)|");
}

TEST(Outline, NamesABlockByItsKindUntilItHasAName) {
  EXPECT_EQ(outline("```quiz\n{\"id\": \"check\"}\n```\n"), "check/quiz|");
  EXPECT_EQ(outline("```quiz\n{\"id\": 7}\n```\n```plot\n{\"alt\": \n```\n"),
            "quiz/quiz|plot/plot|");
}

TEST(Outline, LeavesOutWhatIsOnlyText) {
  EXPECT_EQ(outline("```text\nx\n```\n```cpp snippet model=m\n;\n```\n```io\nx\n```\n"), "");
}

// The protocol takes no empty name.
TEST(Outline, GivesAHeadingWithoutWordsAName) {
  EXPECT_EQ(outline("## \n"), "…|");
}

TEST(Outline, SaysHowFarASectionReaches) {
  const json symbols =
      outline_of({"x.md", "## Ä😀\ntext\n```lab simlab\n{}\n```\n## B\nend"}, Units::utf16);
  const json& first = symbols.at(0);
  EXPECT_EQ(lines_of(first.at("range")), "0:0-5:0");
  EXPECT_EQ(lines_of(first.at("selectionRange")), "0:0-0:6");
  EXPECT_EQ(first.at("kind"), 15);
  const json& lab = first.at("children").at(0);
  EXPECT_EQ(lines_of(lab.at("selectionRange")), "2:0-2:13");
  EXPECT_EQ(lab.at("kind"), 19);
  EXPECT_EQ(lines_of(symbols.at(1).at("range")), "5:0-6:3");
}

}  // namespace
}  // namespace mjcourse
