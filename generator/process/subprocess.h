// Run a program that may do anything: fail, hang, flood its output, leave children behind.
//
// The program reads an empty stdin, but where it `answers` or is heard, and has a process group of
// its own. It is killed with the whole group when its wall clock or its output runs over the
// limit. When it ends, what it left behind goes with it. It is killed as well when the work of this
// thread is cancelled (base/cancellation.h). A sandbox says what else it may, and `record_opened`
// has the files noted that it asks for (process/watcher.h tells how).
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "process/sandbox.h"

namespace mjcourse {

struct Command {
  std::vector<std::string> arguments;    // the program (searched in PATH) and its arguments
  std::string folder;                    // the working directory; must exist
  std::vector<std::string> environment;  // "NAME=value", beside the generator's own
  double seconds = 10;                   // wall clock
  std::size_t output_bytes = 1 << 20;    // cap of stdout and of stderr, each
  // With one, the environment is a small fixed one beside `environment`.
  std::optional<Sandbox> sandbox = {};
  bool record_opened = false;  // where there is a sandbox
  bool answers = false;        // it reads questions from its stdin: see ProcessSupervisor::ask
  // Where there is one, its stdin is a socket: this gets each line that the program writes there,
  // without the line's end, and gives what it then reads there. Of all lines, 16 MiB are heard.
  std::function<std::string(std::string_view)> hears = {};
};

struct Outcome {
  enum class End {
    exited,
    killed_by_signal,
    timed_out,
    flooded,  // it printed too much, or said too much to who hears it
    not_started,
    refused,     // it tried what its sandbox does not allow, and was stopped
    overfilled,  // it wrote more files than its sandbox allows, and was stopped
    exhausted,   // with what it started, it took more memory than that allows, and was stopped
  };
  End end = End::not_started;
  int code = 0;          // exit code, signal, or errno
  std::string out, err;  // up to the cap
  // What it tried, as "read /etc/passwd", with the name that it used.
  std::string refused = {};
  // The files that it opened or looked for, there or not: absolute and normal paths, sorted,
  // without those in the system's folders (/usr, /etc, /proc, ...) and those that its sandbox lets
  // it write. Of a listing, the folder. Nothing where that was not asked for, or cannot be known.
  std::optional<std::vector<std::string>> opened = {};
};

Outcome run(const Command& command);

}  // namespace mjcourse
