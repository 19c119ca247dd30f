#include "report/line_diff.h"

#include <gtest/gtest.h>

#include <string>

namespace mjcourse {
namespace {

bool equal_lines(std::string_view a, std::string_view b) {
  return a == b;
}

// Each change as "-2 text" or "+2 text".
std::string changes(const std::vector<std::string_view>& before,
                    const std::vector<std::string_view>& after) {
  std::string text;
  for (const DiffLine& change : line_diff(before, after, equal_lines)) {
    text += change.kind == DiffLine::Kind::gone ? "-" : "+";
    text += std::to_string(change.line) + " " + change.text + "\n";
  }
  return text;
}

TEST(LineDiff, IsEmptyOfTheSameLines) {
  EXPECT_EQ(changes({"a", "b"}, {"a", "b"}), "");
  EXPECT_EQ(changes({}, {}), "");
}

TEST(LineDiff, NumbersWhatComesByTheLineItStandsBefore) {
  EXPECT_EQ(changes({"a", "b", "c"}, {"a", "x", "c"}), "-2 b\n+3 x\n");
  EXPECT_EQ(changes({"a", "c"}, {"a", "b", "c"}), "+2 b\n");
  EXPECT_EQ(changes({"a"}, {"a", "b"}), "+2 b\n");
}

TEST(LineDiff, IsTheShortest) {
  EXPECT_EQ(changes({"a", "b", "c", "a"}, {"b", "c", "a", "a"}), "-1 a\n+4 a\n");
}

TEST(LineDiff, AsksNothingOfHugeTextsButTheirEnds) {
  const std::vector<std::string> words{"x", "y"};
  std::vector<std::string_view> before(5000, words[0]), after(5000, words[1]);
  before.front() = after.front() = "first";
  before.back() = after.back() = "last";
  before[2500] = after[2500] = "middle";
  const std::vector<DiffLine> lines = line_diff(before, after, equal_lines);
  ASSERT_EQ(lines.size(), 2u * 4998);
  EXPECT_EQ(lines.front().line, 2);
  EXPECT_EQ(lines.back().line, 5000);
}

}  // namespace
}  // namespace mjcourse
