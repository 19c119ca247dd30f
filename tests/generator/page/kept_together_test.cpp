#include "page/kept_together.h"

#include <gtest/gtest.h>

#include <string>

namespace mjcourse {
namespace {

std::string kept(const std::string& text) {
  return text.substr(0, kept_length(text));
}

TEST(KeptTogether, IsPunctuation) {
  EXPECT_EQ(kept(", and then"), ",");
  EXPECT_EQ(kept(")."), ").");
  EXPECT_EQ(kept(" and then"), "");
  EXPECT_EQ(kept(""), "");
}

TEST(KeptTogether, IsAUnitWithWhatIsBehindIt) {
  EXPECT_EQ(kept(" m away"), " m");
  EXPECT_EQ(kept(" N m, and then"), " N m,");
  EXPECT_EQ(kept(" rad/s."), " rad/s.");
  EXPECT_EQ(kept(" meters"), "");
  EXPECT_EQ(kept(" (m)"), "");
  EXPECT_EQ(kept("\nm"), "");
}

}  // namespace
}  // namespace mjcourse
