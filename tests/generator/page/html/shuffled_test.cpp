#include "page/html/shuffled.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace mjcourse {
namespace {

TEST(Shuffled, HoldsEachIndexOnce) {
  for (std::size_t count = 2; count <= 26; ++count) {
    std::vector<std::size_t> order = shuffled(count, "quiz-1");
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(order[i], i);
  }
}

TEST(Shuffled, IsTheSameInEveryBuild) {
  EXPECT_EQ(shuffled(5, "quiz-1-2-check-1"), (std::vector<std::size_t>{1, 4, 0, 2, 3}));
}

TEST(Shuffled, ComesInEveryOrderButTheRightOne) {
  std::set<std::vector<std::size_t>> orders;
  for (int seed = 0; seed < 200; ++seed) orders.insert(shuffled(3, std::to_string(seed)));
  EXPECT_EQ(orders.size(), 5u);
  EXPECT_EQ(orders.count({0, 1, 2}), 0u);
  EXPECT_EQ(shuffled(2, "a"), (std::vector<std::size_t>{1, 0}));
}

}  // namespace
}  // namespace mjcourse
