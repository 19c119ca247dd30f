// ActionStore: what actions gave, by all that they depend on.
//
// One for a run of mjcourse: it remembers what was done or found in this run, and asks the store of
// results for the rest. A result that is found comes with its trace, as if the work had been done.
// Tested by tests/generator/actions/native_program_test.cpp.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "cache/dependency.h"
#include "cache/result_store.h"
#include "cache/trace.h"

namespace mjcourse {

// From any thread.
class ActionStore {
 public:
  // `root` is the course's folder.
  explicit ActionStore(std::filesystem::path root) : root_(std::move(root)) {}

  // Without it, results are kept for this run alone. It must outlive this.
  void keep_in(ResultStore& results) { results_ = &results; }

  // Gives the bytes of the action of that recipe; `trace` gets what it looked at.
  std::optional<std::string> find(const Dependencies& recipe, Trace& trace);

  // The action gave `bytes`. It began at `begin` and looked at what is in `trace`.
  void keep(const Dependencies& recipe, const Trace& trace,
            std::chrono::system_clock::time_point begin, std::string bytes);

 private:
  struct Known {
    std::string bytes;
    Trace trace;
    Dependencies traced;  // with what was behind its names, where results are kept
  };
  std::optional<Known> remembered(const std::string& hash);

  std::filesystem::path root_;
  ResultStore* results_ = nullptr;
  std::mutex mutex_;
  std::map<std::string, Known> known_;  // by the hash of the recipe
};

// `kind` and `text` are the action's. Beside these stand the sources of all actions.
Dependencies action_recipe(const std::string& kind, const std::vector<std::string>& text);

}  // namespace mjcourse
