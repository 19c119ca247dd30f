// Giving up root, for good, in a process that is about to become somebody else's program.
// Tested by tests/generator/process/sandbox_test.cpp.
#pragma once

#include <sys/types.h>

namespace mjcourse {

// Are we root with the capabilities that it takes to become another user, to give it files, and
// afterwards to end its processes and remove its files?
bool may_change_user();

// Only for a child between fork and exec; async-signal-safe. The process is `id` with the group of
// the same number and no other. It keeps no capability but, with `read_all`, the one that lets it
// read files whatever their mode: where Landlock says which, a course may lie in a closed folder.
bool become_user(uid_t id, bool read_all);

}  // namespace mjcourse
