// How many threads work, and what the worker of each may take, so that all of them together leave
// the machine enough to live on, whatever a course makes of each.
#pragma once

#include <cstddef>
#include <cstdint>

#include "evaluate/worker.h"

namespace mjcourse {

struct Concurrency {
  std::size_t threads;
  WorkLimits limits;
};

// Of `threads` that are wanted on a machine with so many bytes of memory. The workers have three
// quarters of it, in equal parts, and each at most what one may have anyway. Where that is less
// than an honest worker needs, there are fewer.
Concurrency concurrency_of(std::size_t threads, std::uint64_t memory);

}  // namespace mjcourse
