#include "base/cancellation.h"

#include <gtest/gtest.h>

#include <thread>

namespace mjcourse {
namespace {

bool is_cancelled() {
  try {
    end_if_cancelled();
    return false;
  } catch (const Cancelled&) {
    return true;
  }
}

TEST(Cancellation, IsOfTheThreadThatSaidSo) {
  const std::stop_source stop;
  const Cancellable cancellable(stop.get_token());
  EXPECT_FALSE(is_cancelled());
  stop.request_stop();
  EXPECT_TRUE(is_cancelled());
  bool other = true;
  std::jthread([&] { other = is_cancelled(); }).join();
  EXPECT_FALSE(other);
}

TEST(Cancellation, IsHandedOnToThreadsThatHelp) {
  const std::stop_source stop;
  const Cancellable cancellable(stop.get_token());
  stop.request_stop();
  bool other = false;
  std::jthread([&other, token = cancellation()] {
    const Cancellable helping(token);
    other = is_cancelled();
  }).join();
  EXPECT_TRUE(other);
}

TEST(Cancellation, EndsWhereItsScopeEnds) {
  const std::stop_source stop;
  stop.request_stop();
  {
    const Cancellable cancellable(stop.get_token());
    EXPECT_TRUE(is_cancelled());
  }
  EXPECT_FALSE(is_cancelled());
}

}  // namespace
}  // namespace mjcourse
