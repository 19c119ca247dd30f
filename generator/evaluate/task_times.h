// TaskTimes: what each task of a course took when it was last worked on, for whoever plans its
// work.
//
// One entry in the store for a course, under its title. Only a run of the whole course writes it,
// so shards that begin one after the other read the same. A wrong one costs time, and nothing else.
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
  // Does nothing where they are about as they were.
  void write() const;

 private:
  using Known = std::pair<std::int64_t, std::string>;  // microseconds, and the text's hash

  Store* store_;
  const std::string name_;
  std::map<std::string, Known> known_;  // by a hash of the task's name
  bool changed_ = false;
};

}  // namespace mjcourse
