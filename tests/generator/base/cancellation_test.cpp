#include "base/cancellation.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "base/stopwatch.h"
#include "base/subprocess.h"

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

TEST(Cancellation, KillsTheProgramThatIsWaitedFor) {
  const std::stop_source stop;
  const Cancellable cancellable(stop.get_token());
  const std::jthread impatient([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    stop.request_stop();
  });
  Command command;
  command.arguments = {"sleep", "60"};
  command.folder = "/";
  command.seconds = 60;
  const Stopwatch stopwatch;
  EXPECT_THROW(run(command), Cancelled);
  EXPECT_LT(stopwatch.seconds(), 30);
}

}  // namespace
}  // namespace mjcourse
