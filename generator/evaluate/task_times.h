// TaskTimes: how long each task of a course took when it was last worked on. Shards are dealt by
// it.
//
// The store has one entry for a course, under its title. Only a run of the whole course writes it,
// so shards that begin one after the other read the same. A wrong time costs nothing but time.
// Tested by tests/generator/evaluate/task_times_test.cpp.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "base/store.h"
#include "evaluate/task.h"

namespace mjcourse {

class TaskTimes {
 public:
  // The store may be null, and must outlive this.
  TaskTimes(Store* store, const std::string& course);

  struct Expected {
    std::chrono::microseconds lasts{};
    bool is_edited = false;  // the lesson says something else of it than then
  };
  // Of a task that was never worked on, about.
  Expected of(const Task& task, const Dependencies& recipe) const;

  void note(const Task& task, const Dependencies& recipe, double seconds);
  // All that was noted, and no task that the course no longer has. Does nothing where all is about
  // as it was.
  void write() const;

 private:
  using Known = std::pair<std::int64_t, std::string>;  // microseconds, and the text's hash

  Store* store_;
  const std::string name_;
  Origin origin_;                               // of those that are known
  std::map<std::string, Known> known_, noted_;  // by a hash of the task's name
};

}  // namespace mjcourse
