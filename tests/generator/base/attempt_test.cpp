#include "base/attempt.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <new>
#include <stdexcept>
#include <vector>

namespace mjcourse {
namespace {

constexpr std::uint64_t kBytes = 200 << 20;

TEST(Attempt, LeavesNothingButHowItEnded) {
  int number = 1;
  EXPECT_EQ(attempt([&] { number = 2; }, kBytes, 10), Attempt::done);
  EXPECT_EQ(number, 1);
}

TEST(Attempt, BoundsMemory) {
  const auto take = [](std::size_t bytes) {
    return [bytes] {
      const std::vector<char> many(bytes, 'x');
      if (many[bytes / 2] != 'x') raise(SIGABRT);
    };
  };
  EXPECT_EQ(attempt(take(kBytes / 10), kBytes, 10), Attempt::done);
#ifndef __SANITIZE_ADDRESS__  // which ends the process at once
  EXPECT_EQ(attempt(take(10 * kBytes), kBytes, 10), Attempt::too_much_memory);
#endif
}

TEST(Attempt, BoundsTime) {
  const auto work = [] {
    for (;;) pause();
  };
  EXPECT_EQ(attempt(work, kBytes, 0.2), Attempt::too_long);
}

TEST(Attempt, SurvivesACrash) {
  EXPECT_EQ(attempt([] { raise(SIGSEGV); }, kBytes, 10), Attempt::crashed);
  EXPECT_EQ(attempt([] { throw std::runtime_error("no"); }, kBytes, 10), Attempt::crashed);
}

}  // namespace
}  // namespace mjcourse
