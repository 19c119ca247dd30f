#include "base/folded_name.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(FoldedName, IsTheSameForAllSpellings) {
  EXPECT_EQ(folded_name("Ann-1"), "ann-1");
  EXPECT_EQ(folded_name("RENE\u0301"), "ren\u00e9");
  EXPECT_EQ(folded_name("\u00c9va Gro\u00df"), folded_name("e\u0301VA GROSS"));
  EXPECT_NE(folded_name("rene"), folded_name("ren\u00e9"));
  EXPECT_EQ(folded_name(""), "");
  EXPECT_EQ(folded_name("A\xff"), "a\ufffd");
}

}  // namespace
}  // namespace mjcourse
