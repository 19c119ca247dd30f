#include "lesson/json/tolerance.h"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

namespace mjcourse {
namespace {

// The page is held against the same table, by tests/site/near.mjs.
TEST(Tolerance, AllowsWhatThePageAllows) {
  std::ifstream file(MJCOURSE_ROOT "/tests/near.json");
  for (const nlohmann::json& row : nlohmann::json::parse(file)) {
    const Tolerance tolerance{row["tolerance"]};
    EXPECT_EQ(tolerance.allows(row["given"], row["right"]), row["near"]) << row;
  }
}

TEST(Tolerance, MayBeAPartOfTheRightNumber) {
  const Tolerance tolerance{0.01, true};
  EXPECT_TRUE(tolerance.allows(-202, -200));
  EXPECT_FALSE(tolerance.allows(-202.1, -200));
  EXPECT_FALSE(tolerance.allows(std::numeric_limits<double>::quiet_NaN(), -200));
}

TEST(Tolerance, KnowsTheRoundingOfSeveralNumbers) {
  EXPECT_EQ(rounding({1, 2, 3}), 0);
  EXPECT_EQ(rounding({1, -2.5}), 2.5e-12);
  EXPECT_EQ(rounding({0x1p53}), 0x1p53 * 1e-12);
}

}  // namespace
}  // namespace mjcourse
