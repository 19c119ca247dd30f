// TaskStore: the findings of tasks, kept in a store under what they depend on.
// Tested by tests/generator/evaluate/evaluate_test.cpp.
#pragma once

#include <chrono>
#include <optional>

#include "cache/result_store.h"
#include "evaluate/codec/result_codec.h"
#include "evaluate/last_run.h"
#include "evaluate/task.h"

namespace mjcourse {

// What came of one task.
struct TaskRecord {
  Finding finding;
  Dependencies recipe, traced;  // what it depends on; the latter where it was kept, or found
  bool reused = false;          // it was kept before
  std::string result = {};      // its name in the store, where it was found there
  Origin origin = {};           // of that
  bool open = false;            // nobody worked on it: what is known does not have it
  bool looked = false;          // it was prepared, and looked up
  bool waiting = false;         // its work is to be done
  std::size_t said = 0;         // diagnostics, when it was prepared
  std::size_t thread = 0;
  double begin = 0, seconds = 0;  // measured, since the scheduler began
  double in_page = 0;             // of these seconds
};

class TaskStore {
 public:
  // `root` is the course's folder. Both others must outlive this.
  TaskStore(Store& store, const std::filesystem::path& root, Fingerprints& fingerprints)
      : root_(std::filesystem::absolute(root).lexically_normal()),
        at_once_(store.at_once()),
        results_(store, fingerprints),
        last_run_(store, root_),
        codec_(store, root_) {}

  // Does `record`, which has its recipe, get its finding? Where this is to be `noted`, last() will
  // know of it.
  bool find(const Task& task, TaskRecord& record, bool noted = true);

  // The way to the finding of `record`, which was kept, is put into the store anew, for one that
  // others look into.
  void put_list(const TaskRecord& record) { results_.put_list(record.recipe, record.traced); }

  // How many may look at once.
  std::size_t at_once() const { return at_once_; }

  // For what else is kept there.
  ResultStore& results() { return results_; }

  // All that the task depended on when it was last kept or found, one by one; empty where it never
  // was.
  Dependencies last(const Task& task);
  Dependency now(const std::string& name) { return results_.now(name); }
  Dependencies one_by_one(const Dependencies& traced) { return results_.one_by_one(traced); }

  // Keep the finding of `record`, whose work began at `begin` and looked at what is in `trace`.
  void keep(const Task& task, const Trace& trace, std::chrono::system_clock::time_point begin,
            TaskRecord& record);

 private:
  std::filesystem::path root_;
  std::size_t at_once_;
  ResultStore results_;
  LastRun last_run_;
  ResultCodec codec_;
};

}  // namespace mjcourse
