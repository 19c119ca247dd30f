// A change of a file's mode, times or length, which a confined program asks for and its watcher
// makes.
//
// Landlock looks at none of them, or only where it is new. If the kernel went on with a call of
// whose path we approved, a thread of the program could put another file there in between. So we
// open the file, look where it lies, and change what we opened.
// Tested by tests/generator/process/confined_calls_test.cpp.
#pragma once

#include <seccomp.h>

#include <cstdint>
#include <string>
#include <vector>

namespace mjcourse {

// Is the system call with that number such a change?
bool is_file_change(int call);

// What the asker may change: files that are one of `own`, or lie in there (absolute paths without
// links), up to a length of `bytes`.
struct OwnFiles {
  const std::vector<std::string>& own;
  std::uint64_t bytes;
};

// Makes the change. 0, or the errno for the program. No file becomes one that runs as its owner or
// its group.
int change_file(const seccomp_notif& question, const OwnFiles& files);

}  // namespace mjcourse
