#include "evaluate/concurrency.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

constexpr std::uint64_t kGiB = std::uint64_t{1} << 30;

TEST(Concurrency, LeavesAWorkerWhatItMayHaveWhereThereIsEnough) {
  const Concurrency concurrency = concurrency_of(2, 24 * kGiB);
  EXPECT_EQ(concurrency.threads, 2U);
  EXPECT_EQ(concurrency.limits.memory, 5 * kGiB);
  EXPECT_EQ(concurrency.limits.seconds, 60);
}

TEST(Concurrency, SharesThreeQuarters) {
  const Concurrency concurrency = concurrency_of(8, 16 * kGiB);
  EXPECT_EQ(concurrency.threads, 8U);
  EXPECT_EQ(concurrency.limits.memory, 3 * kGiB / 2);
}

TEST(Concurrency, HasFewerWorkersRatherThanPoorOnes) {
  const Concurrency concurrency = concurrency_of(64, 8 * kGiB);
  EXPECT_EQ(concurrency.threads, 12U);
  EXPECT_EQ(concurrency.limits.memory, kGiB / 2);
  EXPECT_EQ(concurrency_of(8, kGiB / 4).threads, 1U);
  EXPECT_EQ(concurrency_of(8, kGiB / 4).limits.memory, 3 * kGiB / 16);
}

TEST(Concurrency, IsNeverMoreTogetherThanItsPart) {
  for (const std::uint64_t memory : {kGiB / 8, kGiB, 3 * kGiB, 7 * kGiB, 64 * kGiB, 999 * kGiB}) {
    for (std::size_t threads = 0; threads < 300; ++threads) {
      const Concurrency concurrency = concurrency_of(threads, memory);
      EXPECT_LE(concurrency.threads, threads);
      EXPECT_LE(concurrency.threads * concurrency.limits.memory, memory / 4 * 3);
      if (threads > 0) EXPECT_GE(concurrency.threads, 1U);
    }
  }
  EXPECT_EQ(concurrency_of(4, UINT64_MAX).limits.memory, 5 * kGiB);
}

}  // namespace
}  // namespace mjcourse
