#include "base/code_points.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(CodePoints, AreThoseOfUtf8) {
  EXPECT_EQ(code_points("aä€𝄞"), U"aä€𝄞");
  EXPECT_EQ(code_points("a\xC3\xFFz\xE2\x82"), U"a\uFFFD\uFFFDz\uFFFD\uFFFD");
  EXPECT_EQ(code_points(""), U"");
}

}  // namespace
}  // namespace mjcourse
