// The system calls that name a file, and what each is about to do with it.
// Tested by tests/generator/process/confined_calls_test.cpp.
#pragma once

#include <span>

namespace mjcourse {

enum class FileAccess {
  look,       // is it there, what is it
  read,       // its bytes, or the names in a folder
  write,      // change, make or remove it
  by_flags,   // as open's flags say
  by_struct,  // as openat2's structure says
};

struct PathCall {
  int number;  // of the call; negative where this machine does not have it
  int folder;  // which argument is the folder's descriptor; -1 for none
  int path;    // which argument is the path
  FileAccess access;
  int flags = -1;  // which argument has the flags
};

// A call with two paths is in there twice.
std::span<const PathCall> path_calls();

}  // namespace mjcourse
