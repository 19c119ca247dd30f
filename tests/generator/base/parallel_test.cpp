#include "base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <latch>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace mjcourse {
namespace {

TEST(Parallel, CallsOnceForEachIndex) {
  std::vector<std::atomic<int>> calls(1000);
  for_each_index(calls.size(), 3, [&](std::size_t index, std::size_t) { ++calls[index]; });
  for (const std::atomic<int>& count : calls) EXPECT_EQ(count, 1);
  for_each_index(0, 3, [](std::size_t, std::size_t) { FAIL() << "there is no index"; });
}

TEST(Parallel, RunsOnAsManyThreadsAsItMayEachWithANumberOfItsOwn) {
  std::latch all(3);  // passed only when three calls run at the same time
  std::vector<std::atomic<int>> calls(3);
  for_each_index(3, 3, [&](std::size_t, std::size_t thread) {
    all.arrive_and_wait();
    ++calls[thread];
  });
  for (const std::atomic<int>& count : calls) EXPECT_EQ(count, 1);
}

TEST(Parallel, WorksOnTheCallersThreadWhereThereIsOneOnly) {
  std::vector<std::size_t> order;
  for_each_index(3, 1, [&](std::size_t index, std::size_t thread) {
    EXPECT_EQ(thread, 0U);
    order.push_back(index);
  });
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2}));
}

TEST(Parallel, ThrowsTheExceptionOfTheLowestIndexWhicheverThreadCameFirst) {
  for (int trial = 0; trial < 50; ++trial) {
    std::atomic<bool> later_failed = false;
    std::string message;
    try {
      for_each_index(100, 2, [&](std::size_t index, std::size_t) {
        if (index == 3) {
          while (!later_failed) std::this_thread::yield();
        }
        if (index < 3) return;
        later_failed = index > 3;
        throw std::runtime_error(std::to_string(index));
      });
    } catch (const std::runtime_error& error) {
      message = error.what();
    }
    EXPECT_EQ(message, "3");
  }
}

TEST(Parallel, BeginsNothingBehindAFailure) {
  std::size_t last = 0;
  EXPECT_THROW(for_each_index(100, 1,
                              [&](std::size_t index, std::size_t) {
                                last = index;
                                if (index == 5) throw std::runtime_error("five");
                              }),
               std::runtime_error);
  EXPECT_EQ(last, 5U);
}

}  // namespace
}  // namespace mjcourse
