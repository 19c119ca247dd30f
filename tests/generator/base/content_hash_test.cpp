#include "base/content_hash.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(ContentHash, IsTheSameForTheSameContentAndAnotherForAnother) {
  EXPECT_EQ(content_hash("a"), content_hash("a"));
  EXPECT_NE(content_hash("a"), content_hash("b"));
  EXPECT_NE(content_hash("ab"), content_hash("ba"));
  EXPECT_EQ(content_hash("").size(), 10U);
}

// The published 64-bit value of "a" is af63dc4c8601ec8c; here in base 36, its last digits first.
TEST(ContentHash, IsFnv1a) {
  EXPECT_EQ(content_hash("a"), "grr4viogno");
}

}  // namespace
}  // namespace mjcourse
