#include "cli/progress_bar.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <string_view>

#include "base/utf8.h"

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

// The beginning of `line` that takes so many columns at most: a longer one would go on in the next
// line of the terminal, where nobody wipes it.
std::string beginning_within(const std::string& line, int columns) {
  std::size_t end = 0;
  while (end < line.size()) {
    const std::size_t next = character_end(line, end);
    if (count_columns(std::string_view(line).substr(0, next)) > columns) break;
    end = next;
  }
  return line.substr(0, end);
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
  std::cerr << '\r' << beginning_within(line, terminal_width() - 1) << "\033[K" << std::flush;
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
