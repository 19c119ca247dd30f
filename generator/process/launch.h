// The way of a child until it has become a program.
//
// The child works in our memory until then, as after vfork: to copy the page tables of a generator
// that has read a course, and to give the copy up, takes longer than many a program. So it makes
// system calls and changes nothing of ours, and everything that allocates is done before.
// Tested by tests/generator/process/subprocess_test.cpp.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "base/descriptor.h"
#include "process/confinement.h"
#include "process/group_killer.h"
#include "process/subprocess.h"

namespace mjcourse {

class Launch {
 public:
  // The ends that the program has: of the pipes of its streams, and the socket of its news. Where
  // `in` is not open, its stdin is empty.
  struct Ends {
    Descriptor in, out, err, news;
  };

  // The command must stay until go() has returned.
  Launch(const Command& command, Ends ends);

  // Makes the child. The calling thread stands still until that has become the program or has
  // failed to, which may take an answer of its watcher: so another one must read the news. The
  // kernel ends the program with this thread. False when there is no child, as the news say.
  bool go();

 private:
  [[noreturn]] void become() const;

  const Command& command_;
  Confinement confinement_;
  pid_t parent_;
  const GroupKiller& killer_;
  Ends ends_;
  std::vector<std::string> fixed_;
  std::vector<char*> arguments_, environment_;  // as execvpe takes them
};

}  // namespace mjcourse
