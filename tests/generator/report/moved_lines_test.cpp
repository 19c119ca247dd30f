#include "report/moved_lines.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

using Lines = std::vector<DiffLine>;

DiffLine gone(int line, const std::string& text) {
  return {DiffLine::Kind::gone, line, text};
}
DiffLine come(int before, const std::string& text) {
  return {DiffLine::Kind::come, before, text};
}

// "1100 lines 1-2 moved below line 4|"
std::string moved_in(const Lines& lines) {
  const MovedLines found =
      moved_lines(lines, [](std::string_view a, std::string_view b) { return a == b; });
  std::string text;
  for (const char moved : found.moved) text += moved != 0 ? '1' : '0';
  for (const std::string& note : found.notes) text += " " + note + "|";
  return text;
}

TEST(MovedLines, AreThoseThatComeElsewhere) {
  EXPECT_EQ(moved_in({gone(3, "a"), come(9, "a")}), "11 line 3 moved below line 8|");
  EXPECT_EQ(moved_in({come(2, "a"), gone(7, "a")}), "11 line 7 moved above line 2|");
  EXPECT_EQ(moved_in({gone(3, "a"), come(9, "b")}), "00");
}

TEST(MovedLines, ThatMovedTogetherAreToldTogether) {
  EXPECT_EQ(moved_in({gone(3, "a"), gone(4, "b"), come(9, "a"), come(9, "b")}),
            "1111 lines 3-4 moved below line 8|");
  EXPECT_EQ(moved_in({gone(3, "a"), gone(4, "b"), come(9, "b"), come(9, "a")}),
            "1111 line 3 moved below line 8| line 4 moved below line 8|");
  EXPECT_EQ(moved_in({gone(3, "a"), gone(5, "b"), come(9, "a"), come(9, "b")}),
            "1111 line 3 moved below line 8| line 5 moved below line 8|");
}

TEST(MovedLines, AreEachFoundOnce) {
  EXPECT_EQ(moved_in({gone(3, "a"), gone(4, "a"), come(9, "a")}), "101 line 3 moved below line 8|");
}

TEST(MovedLines, AreNoEmptyOnes) {
  EXPECT_EQ(moved_in({gone(3, " \t\r"), come(9, " \t\r")}), "00");
}

TEST(MovedLines, AreNotLookedForInAVeryLongDiff) {
  Lines lines{gone(1, "a")};
  for (int i = 2; i <= 1000; ++i) lines.push_back(come(5000, i < 1000 ? "b" : "a"));
  EXPECT_EQ(moved_in(lines).substr(1000), " line 1 moved below line 4999|");
  lines.push_back(come(5000, "b"));
  EXPECT_EQ(moved_in(lines), std::string(1001, '0'));
}

}  // namespace
}  // namespace mjcourse
