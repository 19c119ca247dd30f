#include "lsp/quiet_moment.h"

#include <gtest/gtest.h>

#include <atomic>
#include <semaphore>

namespace mjcourse {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

TEST(QuietMoment, ComesOnceAfterManyDisturbances) {
  std::atomic<int> times = 0;
  std::binary_semaphore done{0};
  std::atomic<Clock::time_point> acted;
  QuietMoment moment(40ms, [&] {
    acted = Clock::now();
    ++times;
    done.release();
  });
  Clock::time_point last;
  for (int i = 0; i < 5; ++i) {
    last = Clock::now();
    moment.disturb();
  }
  ASSERT_TRUE(done.try_acquire_for(10s));
  EXPECT_GE(acted.load() - last, 40ms);
  EXPECT_FALSE(done.try_acquire_for(120ms));
  EXPECT_EQ(times, 1);
}

TEST(QuietMoment, ComesAgainAfterTheNextDisturbance) {
  std::counting_semaphore<> done{0};
  QuietMoment moment(1ms, [&] { done.release(); });
  for (int i = 0; i < 3; ++i) {
    moment.disturb();
    ASSERT_TRUE(done.try_acquire_for(10s));
  }
}

TEST(QuietMoment, MayBeDisturbedByWhatIsDone) {
  std::counting_semaphore<> done{0};
  std::atomic<int> left = 2;
  QuietMoment* self = nullptr;
  QuietMoment moment(1ms, [&] {
    if (left-- > 0) self->disturb();
    done.release();
  });
  self = &moment;
  moment.disturb();
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(done.try_acquire_for(10s));
}

TEST(QuietMoment, NeverComesWithoutADisturbanceNorAfterItsEnd) {
  std::atomic<int> times = 0;
  {
    const QuietMoment moment(0ms, [&] { ++times; });
  }
  EXPECT_EQ(times, 0);
  const Clock::time_point begin = Clock::now();
  {
    QuietMoment moment(1h, [&] { ++times; });
    moment.disturb();
  }
  EXPECT_EQ(times, 0);
  EXPECT_LT(Clock::now() - begin, 10s);
}

}  // namespace
}  // namespace mjcourse
