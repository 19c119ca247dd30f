#include "base/running_text.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(RunningText, HasSingleBlanks) {
  EXPECT_EQ(with_single_blanks("  one \n\t two\r\n\fthree\v"), "one two three");
  EXPECT_EQ(with_single_blanks("Größe\xC2\xA0 2"), "Größe\xC2\xA0 2");  // one that does not break
  EXPECT_EQ(with_single_blanks(" \n "), "");
  EXPECT_EQ(with_single_blanks(""), "");
}

TEST(RunningText, IsCutBetweenWords) {
  EXPECT_EQ(beginning_of("one two", 7), "one two");
  EXPECT_EQ(beginning_of("one two", 6), "one");
  EXPECT_EQ(beginning_of("ⅰⅰⅰ", 4), "ⅰ");
}

}  // namespace
}  // namespace mjcourse
