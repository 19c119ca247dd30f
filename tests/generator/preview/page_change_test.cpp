#include "preview/page_change.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

// A page whose text has these parts, each a line long and two lines from the one before.
std::string page(const std::vector<std::string>& parts, const std::string& title = "T",
                 int line = 1) {
  std::string html = "<title>" + title + "</title><main>\n";
  for (const std::string& part : parts) {
    const std::string at = std::to_string(line);
    html += "<!--lines " + at + "-" + at + "-->\n<p>" + part + "</p>\n";
    line += 2;
  }
  return html + "<!--lines-->\n</main>\n";
}

void expect_change(const std::string& before, const std::string& after, std::size_t first,
                   std::size_t count, const std::string& html) {
  const auto change = page_change(before, after);
  ASSERT_TRUE(change);
  EXPECT_EQ(change->first, first);
  EXPECT_EQ(change->count, count);
  EXPECT_EQ(change->html, html);
}

TEST(MarksOf, TellsTheLinesOfEachPart) {
  EXPECT_EQ(marks_of("<!--lines 3-4--><p>a</p><!--lines 6-9 running--><p>b</p><!--lines-->"),
            (std::vector<PageMark>{{3, 4, false}, {6, 9, true}}));
  EXPECT_TRUE(marks_of("<p>no lesson</p>").empty());
  EXPECT_TRUE(marks_of("").empty());
}

TEST(PageChange, IsThePartThatChanged) {
  expect_change(page({"a", "b", "c"}), page({"a", "B", "c"}), 1, 1, "<!--lines 3-3-->\n<p>B</p>\n");
}

TEST(PageChange, IsThePartsThatCame) {
  expect_change(page({"a", "c"}), page({"a", "b", "c"}), 1, 0, "<!--lines 3-3-->\n<p>b</p>\n");
  expect_change(page({"a"}), page({"a", "b"}), 1, 0, "<!--lines 3-3-->\n<p>b</p>\n");
  expect_change(page({}), page({"a"}), 0, 0, "<!--lines 1-1-->\n<p>a</p>\n");
}

TEST(PageChange, IsThePartsThatWent) {
  expect_change(page({"a", "b", "c"}), page({"c"}), 0, 2, "");
  expect_change(page({"a", "a", "a"}), page({"a", "a"}), 2, 1, "");
}

TEST(PageChange, IsNoneWhereTheTextMoved) {
  expect_change(page({"a", "b"}), page({"a", "b"}, "T", 7), 2, 0, "");
}

TEST(PageChange, IsUnknownWhereTheRestChanged) {
  EXPECT_FALSE(page_change(page({"a"}), page({"a"}, "another title")));
  EXPECT_FALSE(page_change("<p>home</p>", "<p>another</p>"));
  EXPECT_FALSE(page_change(page({"a"}), ""));
}

}  // namespace
}  // namespace mjcourse
