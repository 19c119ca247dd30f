// The system calls that a program of somebody else's may make, as a seccomp filter.
//
// It denies what no program of a lesson needs and what reaches beyond it: other processes, the
// network, mounts, namespaces, keys, kernel interfaces with a long record of holes, memory and
// queues that outlive a process. It also denies every call that is newer than the list, of which
// nobody knows what it may reach. Calls that name a file are put to a watcher, where there is one.
// Tested by tests/generator/process/confined_calls_test.cpp.
#pragma once

#include <linux/filter.h>

#include <vector>

namespace mjcourse {

using SyscallFilter = std::vector<sock_filter>;

struct FilterKind {
  bool confine = false;    // deny what reaches beyond the program
  bool processes = false;  // but let it start others
  bool watch = false;      // tell the watcher of files
  bool asked = false;      // is there a watcher, who decides where an argument does?
  bool scoped = false;     // does Landlock keep signals among those that are confined together?
  bool network = false;    // let it ask others on the network
  bool narrows = false;    // let it have a filter of its own behind this one
};

// Does the kernel know of watchers at all? Else no filter for one can be made.
bool can_watch();

// Made once for each kind. Throws std::system_error when libseccomp cannot.
const SyscallFilter& syscall_filter(FilterKind kind);

// Both only for a child between fork and exec, behind no_new_privs; async-signal-safe.
bool enter_filter(const SyscallFilter& filter);
// A descriptor for the watcher, or -1.
int enter_filter_with_listener(const SyscallFilter& filter);

}  // namespace mjcourse
