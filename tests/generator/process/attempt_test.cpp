#include "process/attempt.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <memory>
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

#ifndef __SANITIZE_ADDRESS__  // whose shadow counts too
// A library may reserve what it never needs.
TEST(Attempt, CountsTheMemoryThatIsUsed) {
  const auto touch = [](std::size_t bytes) {
    return [bytes] {
      const std::unique_ptr<char[]> many(new char[3 * kBytes]);
      std::memset(many.get(), 'x', bytes);
      if (many[bytes / 2] != 'x') raise(SIGABRT);
    };
  };
  EXPECT_EQ(attempt(touch(kBytes / 2), kBytes, 10), Attempt::done);
  EXPECT_EQ(attempt(touch(2 * kBytes), kBytes, 10), Attempt::too_much_memory);
}

// One allocation after the other is more than the largest of them, and no more than the peak.
TEST(Attempt, CountsTheMostAtOneTime) {
  const auto one_by_one = [](bool keeps) {
    return [keeps] {
      std::vector<std::vector<char>> kept;
      for (int i = 0; i < 8; ++i) {
        if (!keeps) kept.clear();
        kept.emplace_back(kBytes / 3, 'x');
      }
    };
  };
  EXPECT_EQ(attempt(one_by_one(false), kBytes, 10), Attempt::done);
  EXPECT_EQ(attempt(one_by_one(true), kBytes, 10), Attempt::too_much_memory);
}
#endif

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
