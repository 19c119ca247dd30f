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
#include <map>
#include <set>
#include <string>
#include <vector>

#include "evaluate/context/worker_context.h"
#include "evaluate/plan.h"
#include "evaluate/task_times.h"

namespace mjcourse {

// Of a course that one machine does, 1 of 1.
struct Shard {
  std::size_t number = 1, count = 1;  // number is from 1 to count

  bool is_whole() const { return count == 1; }
  // It tells of all that no task finds out.
  bool is_first() const { return number == 1; }
};

// What one machine does as a whole.
struct Portion {
  std::string name;  // decides between two that are as long
  std::chrono::microseconds edited{}, kept{};
};

// The number, from 1 to `shards`, of the shard of each portion.
std::vector<std::size_t> deal(const std::vector<Portion>& portions, std::size_t shards);

// What one shard does of a course.
class Share {
 public:
  // Takes out of `tasks` what other shards do.
  Share(Tasks& tasks, const Shard& shard, const TaskTimes& times, const RunContext& run_context);

  // The names of the programs that others run.
  const std::vector<std::string>& programs_of_others() const { return programs_of_others_; }
  // The same on all machines that have divided the course alike: the first digits of a hash.
  const std::string& division() const { return division_; }
  // The blocks of a page that are theirs: of which there is no result here, no claim and no
  // message.
  std::set<std::size_t> blocks_of_others(const Lesson& page) const;

 private:
  void note(const Task& task, bool is_ours);

  struct Blocks {
    std::set<std::size_t> ours, others;
  };
  bool is_first_;
  std::string division_;
  std::map<const Lesson*, Blocks> worked_on_;  // by tasks
  std::map<std::string, bool> is_ours_;        // programs, by their files
  std::vector<std::string> programs_of_others_;
};

}  // namespace mjcourse
