#include "evaluate/shard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace mjcourse {
namespace {

using std::chrono::microseconds;

// As a course has them: many that are short, a few that are long.
std::vector<Portion> portions_of(std::size_t count) {
  std::vector<Portion> portions;
  for (std::size_t i = 0; i < count; ++i) {
    const auto lasts = microseconds(1'000 + i * 7919 % 2'000'000);
    portions.push_back({"task " + std::to_string(i), i % 10 == 0 ? lasts : microseconds(0),
                        i % 10 == 0 ? microseconds(0) : lasts});
  }
  return portions;
}

// The longest share by the mean.
double unevenness(const std::vector<Portion>& portions, microseconds Portion::*time,
                  std::size_t shards) {
  std::vector<double> loads(shards);
  const std::vector<std::size_t> dealt = deal(portions, shards);
  for (std::size_t i = 0; i < portions.size(); ++i) {
    loads[dealt[i] - 1] += static_cast<double>((portions[i].*time).count());
  }
  return *std::ranges::max_element(loads) * static_cast<double>(shards) /
         std::accumulate(loads.begin(), loads.end(), 0.0);
}

TEST(Deal, GivesEachShardAsMuchOfWhatWasEditedAndOfTheRest) {
  const std::vector<Portion> portions = portions_of(2'400);
  for (const std::size_t shards : {1U, 2U, 4U, 8U}) {
    EXPECT_LT(unevenness(portions, &Portion::edited, shards), 1.05) << shards;
    EXPECT_LT(unevenness(portions, &Portion::kept, shards), 1.05) << shards;
  }
}

TEST(Deal, DoesNotMindTheOrder) {
  std::vector<Portion> portions = portions_of(100);
  std::map<std::string, std::size_t> there;
  const auto forth = deal(portions, 7);
  for (std::size_t i = 0; i < portions.size(); ++i) there[portions[i].name] = forth[i];
  std::ranges::reverse(portions);
  const auto back = deal(portions, 7);
  for (std::size_t i = 0; i < portions.size(); ++i) {
    EXPECT_EQ(back[i], there[portions[i].name]) << portions[i].name;
  }
}

TEST(Deal, BeginsWithTheLongest) {
  const auto seconds = [](int count) { return microseconds(std::chrono::seconds(count)); };
  EXPECT_EQ(deal({{"a", seconds(1)}, {"b", seconds(2)}, {"c", seconds(4)}, {"d", seconds(3)}}, 2),
            (std::vector<std::size_t>{1, 2, 1, 2}));
}

TEST(Deal, SpreadsWhatTakesNoTime) {
  EXPECT_EQ(deal({{"a"}, {"b"}, {"c"}}, 3), (std::vector<std::size_t>{1, 2, 3}));
}

}  // namespace
}  // namespace mjcourse
