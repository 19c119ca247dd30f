// QuietMoment: something to be done once nothing has happened for a while, as when somebody stops
// typing.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace mjcourse {

class QuietMoment {
 public:
  // `act` is called on a thread of this, `quiet` after the last disturb().
  QuietMoment(std::chrono::milliseconds quiet, std::function<void()> act);

  // From any thread; does not wait.
  void disturb();

 private:
  void run(const std::stop_token& stop);

  std::chrono::milliseconds quiet_;
  std::function<void()> act_;
  std::mutex mutex_;
  std::condition_variable_any disturbed_;
  bool wanted_ = false;
  std::chrono::steady_clock::time_point when_;
  std::jthread thread_;  // last: it uses the rest
};

}  // namespace mjcourse
