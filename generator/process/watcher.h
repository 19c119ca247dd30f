// The watcher of a program: the kernel stops each system call that names a file until we answer.
//
// So every file that a program opens or looks for is known, however its name was made and whichever
// library asked. The answer is `go on`, but for what the sandbox does not allow: then the program
// is to be stopped, and the author told what it tried. The names are read from the program's
// memory, which one of its threads may change in between; so what keeps files safe is Landlock, and
// this only tells of it.
// Tested by tests/generator/process/confined_calls_test.cpp.
#pragma once

#include <seccomp.h>
#include <sys/types.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "process/path_calls.h"
#include "process/sandbox.h"

namespace mjcourse {

class Watcher {
 public:
  // `sandbox` outlives it.
  Watcher(pid_t program, const Sandbox& sandbox);

  // Takes one question from `listener`, and answers it unless the program is to be stopped.
  void answer(int listener);

  // What it tried and may not, as "read /etc/passwd"; empty for nothing.
  const std::string& refused() const { return refused_; }

  // Absolute normal paths that it opened or looked for, there or not, outside of the system's
  // folders and its own; nothing when one of them could not be made out.
  std::optional<std::vector<std::string>> opened() const;

 private:
  enum class Answer { go_on, give, stop };
  struct Reply {
    Answer answer = Answer::go_on;
    int error = 0;  // that the call gives; 0 for done
  };

  Reply decide(const seccomp_notif& question);
  Reply decide_on_path(const seccomp_notif& question, const PathCall& call);
  Reply decide_on_clone(const seccomp_notif& question);
  Reply decide_on_thread(const seccomp_notif& question);
  Reply refuse(std::string what);
  FileAccess access_of(const seccomp_notif& question, const PathCall& call);
  bool may(const std::string& path, bool write) const;

  pid_t program_;
  const Sandbox& sandbox_;
  std::vector<std::string> readable_, writable_;  // without symbolic links
  std::set<std::string> opened_;
  std::string refused_;
  bool all_known_ = true;
  bool begun_ = false;
};

}  // namespace mjcourse
