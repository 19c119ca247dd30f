#include "page/html/search_text.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

// Of a lesson with this body, whose inline values all came to 13.
std::vector<SearchSection> sections_of(const std::string& markdown) {
  const Lesson lesson = std::move(reading_of(markdown).lesson.value());
  LessonResults results;
  for (const std::size_t i : blocks_of<InlineValue>(lesson)) {
    results.of_block[i] = ValueResult{"13", "model.nq of zoo.xml"};
  }
  return search_sections(lesson, results);
}

TEST(SearchText, HasASectionForEachHeading) {
  const auto sections = sections_of("Before *all*.\n\n## One `x`\n\nText.\n\n### Two\n\nMore.\n");
  ASSERT_EQ(sections.size(), 3U);
  EXPECT_EQ(sections[0].anchor, "");
  EXPECT_EQ(sections[0].text, "Before all.");
  EXPECT_EQ(sections[1].title, "One x");
  EXPECT_EQ(sections[1].anchor, "one-x");
  EXPECT_EQ(sections[1].text, "Text.");
  EXPECT_EQ(sections[2].anchor, "two");
}

TEST(SearchText, SaysWhatAReaderSees) {
  const auto sections = sections_of(
      "It has `{zoo} model.nq` numbers,\nas $n_q$ says.\n\n$$\nhidden\n$$\n\n"
      "| a | b |\n|---|---|\n| c | d |\n\n> [!note] Title\n> Of a note.\n");
  EXPECT_EQ(sections[0].text, "It has 13 numbers, as n_q says. a b c d Title Of a note.");
}

TEST(SearchText, KeepsCodeApart) {
  const auto sections = sections_of("Text.\n\n```cpp unchecked\nint  x;\n  mj_step(m, d);\n```\n");
  EXPECT_EQ(sections[0].text, "Text.");
  EXPECT_EQ(sections[0].code, "int x; mj_step(m, d);");
}

}  // namespace
}  // namespace mjcourse
