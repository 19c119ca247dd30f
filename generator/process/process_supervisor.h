// ProcessSupervisor: looks after one program from its start to its end.
//
// Enter with run() of subprocess.h for a program that does its work and ends. One that works for as
// long as it is asked to has a ProcessSupervisor of its own. Question and answer are bytes behind
// their number, as 8 bytes in this machine's order.
// Tested by tests/generator/process/subprocess_test.cpp.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "process/child_process.h"
#include "process/subprocess.h"
#include "process/watcher.h"

namespace mjcourse {

class ProcessSupervisor {
 public:
  // The command must stay as long as this does. Throws std::system_error when the system has no
  // room for another process.
  explicit ProcessSupervisor(const Command& command);

  // Waits for its end.
  Outcome run();

  // Sends the question to a program that `answers`, and gives its answer; or its Outcome where it
  // ends, or takes longer than `seconds`. Throws Cancelled where the caller's work is cancelled; do
  // not use the program after that.
  tl::expected<std::string, Outcome> ask(std::string_view question, double seconds);

 private:
  using Clock = std::chrono::steady_clock;

  void stop(Outcome::End end);
  void allow(double seconds);
  int patience() const;
  void wait_and_serve();
  void hear_news();
  void answer(short events);
  void say();
  void hear();
  void collect(Descriptor& stream, std::string& text);
  void count_use();
  void count_files();
  std::optional<std::string> take_answer();
  Outcome conclude();

  const Command& command_;
  Clock::time_point deadline_;
  ChildProcess child_;
  std::optional<Watcher> watcher_;  // only where there is a sandbox
  Descriptor listener_;
  Clock::time_point next_count_, next_use_;
  std::uint64_t removed_ = 0;   // bytes of files that no folder has
  std::string to_say_, heard_;  // heard_ is the beginning of a line
  std::size_t heard_bytes_ = 0;
  bool hears_ = false;  // somebody does, and may hear more
  Outcome outcome_;
  int status_ = 0;
  bool watched_ = false, ended_ = false, over_ = false;
};

}  // namespace mjcourse
