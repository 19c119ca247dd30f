// GroupKiller: a small process that kills the programs we started where we die before we can.
//
// A generator that is killed, or that crashes, takes its programs along: the kernel kills a child
// whose parent ends. Of what that child has started itself, the kernel knows nothing. So each
// program tells its process group, which a confined one cannot leave, to a process of ours that
// does nothing but wait for our end.
// Tested by tests/generator/process/subprocess_test.cpp.
#pragma once

#include <sys/types.h>

namespace mjcourse {

class GroupKiller {
 public:
  // Of this process; begun by the first caller. A copy of us as we are then, so a program asks
  // before it has taken much memory and begun threads.
  static const GroupKiller& instance();

  // Both are async-signal-safe, and do nothing where none could be begun.
  void watch(pid_t group) const;
  // Call it when nothing of the group is left: from then on another may get its number.
  void forget(pid_t group) const;

 private:
  GroupKiller();
  void tell(pid_t group) const;

  int socket_ = -1;
};

}  // namespace mjcourse
