#include "lsp/quiet_moment.h"

#include <utility>

namespace mjcourse {

QuietMoment::QuietMoment(std::chrono::milliseconds quiet, std::function<void()> act)
    : quiet_(quiet),
      act_(std::move(act)),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

void QuietMoment::disturb() {
  const std::lock_guard lock(mutex_);
  wanted_ = true;
  when_ = std::chrono::steady_clock::now() + quiet_;
  disturbed_.notify_all();
}

void QuietMoment::run(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (disturbed_.wait(lock, stop, [this] { return wanted_; })) {
    while (std::chrono::steady_clock::now() < when_ && !stop.stop_requested()) {
      disturbed_.wait_until(lock, stop, when_, [] { return false; });
    }
    if (stop.stop_requested()) return;
    wanted_ = false;
    lock.unlock();
    act_();
    lock.lock();
  }
}

}  // namespace mjcourse
