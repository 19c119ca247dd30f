#include "cli/progress_bar.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <iostream>

namespace mjcourse {
namespace {

using namespace std::chrono_literals;

constexpr auto kQuickWork = 500ms;  // work that ends before shows no bar
constexpr auto kFrame = 100ms;
constexpr std::size_t kBar = 24;  // characters

int terminal_width() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace

ProgressBar::ProgressBar() {
  if (isatty(STDERR_FILENO) == 0) return;
  painter_ = std::jthread([this](const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, stop, kQuickWork, [] { return false; });
    while (!stop.stop_requested()) {
      draw();
      changed_.wait_for(lock, stop, kFrame, [] { return false; });
    }
    std::cerr << "\r\033[K" << std::flush;
  });
}

ProgressBar::~ProgressBar() = default;

void ProgressBar::draw() {
  const std::size_t filled = tasks_ > 0 ? kBar * finished_ / tasks_ : 0;
  std::string line = "[";
  for (std::size_t i = 0; i < kBar; ++i) line += i < filled ? '=' : ' ';
  line += "] " + std::to_string(finished_) + "/" + std::to_string(tasks_) + " ";
  for (const std::string& what : running_) line += (&what == &running_.front() ? " " : ", ") + what;
  line.resize(std::min(line.size(), static_cast<std::size_t>(terminal_width() - 1)));
  std::cerr << '\r' << line << "\033[K" << std::flush;
}

void ProgressBar::plan(std::size_t tasks) {
  const std::lock_guard lock(mutex_);
  tasks_ = tasks;
}

void ProgressBar::begin(const std::string& what) {
  const std::lock_guard lock(mutex_);
  running_.push_back(what);
}

void ProgressBar::end(const std::string& what) {
  const std::lock_guard lock(mutex_);
  const auto begun = std::find(running_.begin(), running_.end(), what);
  if (begun != running_.end()) running_.erase(begun);
  ++finished_;
}

}  // namespace mjcourse
