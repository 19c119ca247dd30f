// What a process group holds of memory, and of files that no folder has any more: the sums that no
// resource limit of the kernel's looks at, since each is of one process or one file.
#pragma once

#include <sys/types.h>

#include <cstdint>

#include "process/sandbox.h"

namespace mjcourse {

struct GroupUse {
  std::uint64_t memory = 0;  // bytes that are resident; what two processes share counts twice
  // Bytes on the disk of files that were removed and are still open, or only mapped.
  std::uint64_t removed = 0;
};

// Of all processes in the group of `leader`; of one that may start no others, of itself.
GroupUse use_of_group(pid_t leader, const Sandbox& sandbox);

}  // namespace mjcourse
