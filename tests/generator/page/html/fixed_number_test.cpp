#include "page/html/fixed_number.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(FixedNumber, HasItsDigits) {
  EXPECT_EQ(fixed_number(1.0 / 3, 4), "0.3333");
  EXPECT_EQ(fixed_number(13, 0), "13");
  EXPECT_EQ(fixed_number(-2.5, 1), "-2.5");
}

TEST(FixedNumber, KnowsNoNegativeZero) {
  EXPECT_EQ(fixed_number(-0.0, 1), "0.0");
  EXPECT_EQ(fixed_number(-0.04, 1), "0.0");
  EXPECT_EQ(fixed_number(-0.06, 1), "-0.1");
}

}  // namespace
}  // namespace mjcourse
