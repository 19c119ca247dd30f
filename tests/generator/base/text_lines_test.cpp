#include "base/text_lines.h"

#include <gtest/gtest.h>

#include "base/counted.h"

namespace mjcourse {
namespace {

using Lines = std::vector<std::string_view>;

TEST(TextLines, AreTakenWithoutTheirEnds) {
  EXPECT_EQ(lines_of(""), Lines());
  EXPECT_EQ(lines_of("a"), Lines({"a"}));
  EXPECT_EQ(lines_of("a\r\n\n b\r"), Lines({"a", "", " b"}));
  EXPECT_EQ(lines_of("a\n\n"), Lines({"a", ""}));
}

TEST(TextLines, AreTrimmedOfBlanks) {
  EXPECT_EQ(trimmed(" \ta b \r"), "a b");
  EXPECT_EQ(trimmed("a"), "a");
  EXPECT_EQ(trimmed(" \t"), "");
}

TEST(Counted, HasAPluralForAllButOne) {
  EXPECT_EQ(counted(0, "line"), "0 lines");
  EXPECT_EQ(counted(1, "line"), "1 line");
  EXPECT_EQ(counted(2u, "program run", "programs run"), "2 programs run");
}

}  // namespace
}  // namespace mjcourse
