#include "page/html/kept_together.h"

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

TEST(KeptTogether, IsANumberWithItsUnit) {
  EXPECT_EQ(with_kept_units("0.1 s after 2 kg, in 3 steps of 4 m/s."),
            "0.1\u00a0s after 2\u00a0kg, in 3 steps of 4\u00a0m/s.");
  EXPECT_EQ(with_kept_units("5 N m, 2"), "5\u00a0N\u00a0m, 2");
  EXPECT_EQ(with_kept_units("a m"), "a m");
  EXPECT_FALSE(has_units("3 steps, m"));
  EXPECT_TRUE(has_units("3 m"));
}

}  // namespace
}  // namespace mjcourse
