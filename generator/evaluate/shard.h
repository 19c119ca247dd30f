// Shards: the tasks of a course, dealt to machines that say nothing to each other.
//
// Each machine deals for itself. All come to the same, since they read the same course, and from
// the shared store the same times (task_times.h). What belongs together is dealt together: what
// quotes an example with that example, and the two tasks of an exercise. The longest comes first,
// and goes to the shard that has least to do. Lessons that were edited and those that the store
// probably has are dealt each for themselves, so that neither makes up for the other.
// Tested by tests/generator/evaluate/shard_test.cpp.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

#include "evaluate/context/worker_context.h"
#include "evaluate/plan.h"
#include "evaluate/task_times.h"

namespace mjcourse {

struct Shard {
  std::size_t number = 1, count = 1;  // number is from 1 to count
};

// What one machine does as a whole.
struct Portion {
  std::string name;  // decides between two that are as long
  std::chrono::microseconds edited{}, kept{};
};

// The number, from 1 to `shards`, of the shard of each portion.
std::vector<std::size_t> deal(const std::vector<Portion>& portions, std::size_t shards);

// Takes out of `tasks`, and gives, what other shards do.
Tasks take_others(Tasks& tasks, const Shard& shard, const TaskTimes& times,
                  const RunContext& run_context);

}  // namespace mjcourse
