#include "base/source_text.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

// "line:column" of byte `offset`.
std::string place(const SourceText& source, std::size_t offset) {
  const Position position = source.position(offset);
  return std::to_string(position.line) + ":" + std::to_string(position.column);
}

TEST(SourceText, CountsLinesAndColumnsFromOne) {
  const SourceText source("a.md", "ab\n\ncd");
  EXPECT_EQ(place(source, 0), "1:1");
  EXPECT_EQ(place(source, 2), "1:3");  // the line's end belongs to its line
  EXPECT_EQ(place(source, 3), "2:1");
  EXPECT_EQ(place(source, 5), "3:2");
  EXPECT_EQ(source.line_count(), 3);
}

TEST(SourceText, CountsCharactersNotBytes) {
  const SourceText source("a.md", "é→𝄞x");
  EXPECT_EQ(place(source, 2), "1:2");
  EXPECT_EQ(place(source, 5), "1:3");
  EXPECT_EQ(place(source, 9), "1:4");
}

TEST(SourceText, CountsCharactersOfLongLines) {
  std::string text = "a\n";
  for (int i = 0; i < 10'000; ++i) text += "→";
  const SourceText source("a.md", text + "\nb");
  for (const std::size_t i : {0U, 1U, 1364U, 1365U, 1366U, 2730U, 9999U}) {
    EXPECT_EQ(place(source, 2 + 3 * i), "2:" + std::to_string(i + 1));
  }
  EXPECT_EQ(place(source, text.size()), "2:10001");
  EXPECT_EQ(place(source, text.size() + 1), "3:1");
}

TEST(SourceText, TakesAnOffsetPastTheEndAsTheEnd) {
  EXPECT_EQ(place(SourceText("a.md", "ab\nc"), 1000), "2:2");
  EXPECT_EQ(place(SourceText("a.md", "ab\n"), 1000), "2:1");
  EXPECT_EQ(place(SourceText("a.md", ""), 7), "1:1");
}

TEST(SourceText, HasAWholeLineEndBehindTheLastCharacter) {
  const SourceText source("a.md", "ab\r\nc\r");
  EXPECT_EQ(place(source, 2), "1:3");
  EXPECT_EQ(place(source, 3), "1:3");
  EXPECT_EQ(place(source, 4), "2:1");
  EXPECT_EQ(place(source, 6), "2:2");
}

TEST(SourceText, GivesLinesWithoutTheirEnds) {
  const SourceText source("a.md", "one\r\ntwo\n\rthree");
  EXPECT_EQ(source.line(1), "one");
  EXPECT_EQ(source.line(2), "two");
  EXPECT_EQ(source.line(3), "\rthree");  // only before a line feed is it part of the end
  EXPECT_EQ(source.line_start(2), 5u);
}

TEST(SourceText, HasNothingBeyondItsLines) {
  const SourceText source("a.md", "one\n");
  EXPECT_EQ(source.line(2), "");
  EXPECT_EQ(source.line(99), "");
  EXPECT_EQ(source.line_start(99), 4u);
  EXPECT_EQ(source.line_start(0), 0u);
}

}  // namespace
}  // namespace mjcourse
