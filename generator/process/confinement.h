// How a child becomes what its Sandbox lets it be, on its way to becoming a program.
//
// Everything that allocates happens in the constructor, before there is a child; enter() makes
// system calls and nothing else, since the child works in our memory (process/launch.h).
// Tested by tests/generator/process/sandbox_test.cpp.
#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "process/landlock.h"
#include "process/sandbox.h"
#include "process/syscall_filter.h"

namespace mjcourse {

class Confinement {
 public:
  // `sandbox` may be null, for a program that is trusted, and that nobody watches. A program that
  // may start others has a watcher too, which decides what Landlock leaves open. `seconds` is what
  // its wall clock allows.
  Confinement(const Sandbox* sandbox, bool watch, double seconds);

  // In the child. 0, or errno. `listener` becomes the descriptor on which the watcher is asked; it
  // stays -1 where there is none.
  int enter(int& listener) const;

  // Does the child become another user? It is the one change of its own that reaches our memory.
  bool changes_user() const { return level_.user != SandboxLevel::User::same; }

 private:
  struct Limit {
    int resource;
    rlim_t soft, hard;
  };

  bool set_limits() const;
  bool give_files(uid_t user) const;

  bool confines_;
  bool reads_all_ = false;
  SandboxLevel level_;
  std::vector<Limit> limits_;
  std::vector<LandlockRule> rules_;
  std::vector<std::uint16_t> ports_;
  std::vector<std::string> owned_;
  const SyscallFilter* filter_ = nullptr;
  bool asked_;
};

}  // namespace mjcourse
