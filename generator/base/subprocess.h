// Run a program that may do anything: fail, hang, flood its output, leave children behind.
//
// The program reads an empty stdin, has a process group of its own, and is killed with the whole
// group when its wall clock or its output runs over the limit.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace mjcourse {

struct Command {
  std::vector<std::string> arguments;    // the program (searched in PATH) and its arguments
  std::string folder;                    // the working directory; must exist
  std::vector<std::string> environment;  // "NAME=value", beside the generator's own
  double seconds = 10;                   // wall clock
  std::size_t output_bytes = 1 << 20;    // cap of stdout and of stderr, each
};

struct Outcome {
  enum class End { exited, killed_by_signal, timed_out, flooded, not_started };
  End end = End::not_started;
  int code = 0;          // exit code, signal, or errno
  std::string out, err;  // up to the cap
};

Outcome run(const Command& command);

}  // namespace mjcourse
