#include "report/wrapped.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(Wrapped, BreaksAtBlanks) {
  EXPECT_EQ(wrapped("one two three four", 9, 0), "one two\nthree\nfour");
  EXPECT_EQ(wrapped("one two", 7, 0), "one two");
  EXPECT_EQ(wrapped("", 7, 0), "");
}

TEST(Wrapped, GoesOnAtItsColumnAndIndentsWhatFollows) {
  EXPECT_EQ(wrapped("one two three", 12, 2, 6), "one\n  two three");
  EXPECT_EQ(wrapped("one two", 12, 2, 10), "\n  one two");
}

TEST(Wrapped, LeavesWhatIsLongerThanALineWhole) {
  EXPECT_EQ(wrapped("a content/1-state/1.2-state.md b", 10, 2),
            "a\n  content/1-state/1.2-state.md\n  b");
}

TEST(Wrapped, KeepsCodeTogetherWhereALineCanHoldIt) {
  EXPECT_EQ(wrapped("write `mjcourse accept` now", 20, 0), "write\n`mjcourse accept`\nnow");
  EXPECT_EQ(wrapped("write `mjcourse accept 1.2:210` now", 20, 0),
            "write `mjcourse\naccept 1.2:210` now");
  EXPECT_EQ(wrapped("an open ` is no code", 8, 0), "an open\n` is no\ncode");
}

TEST(Wrapped, CountsColumnsAndNotBytes) {
  EXPECT_EQ(wrapped("ééé ééé", 7, 0), "ééé ééé");
  EXPECT_EQ(wrapped("中中 中中", 8, 0), "中中\n中中");
}

TEST(Wrapped, KeepsSeveralBlanks) {
  EXPECT_EQ(wrapped("a  b", 10, 0), "a  b");
}

}  // namespace
}  // namespace mjcourse
