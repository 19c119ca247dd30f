// Runs of several versions of a program, which are compiled once where they can be joined
// (joined_programs.h), and one by one where they cannot.
// Tested by tests/courses/exercise.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "evaluate/programs/example.h"

namespace mjcourse {

class VersionRuns {
 public:
  // `versions` are whole texts of `program`. All but these outlive it.
  VersionRuns(Example program, std::vector<std::string> versions, const Lesson& lesson,
              WorkerContext& worker_context)
      : program_(std::move(program)),
        versions_(std::move(versions)),
        lesson_(lesson),
        worker_context_(worker_context) {}

  // As evaluate_example() of that version.
  std::optional<ExampleResult> run(std::size_t index, Diagnostics& diagnostics);

 private:
  // Compiles all at once; nothing where that does not work, for whatever reason.
  std::optional<CompiledExample> join() const;
  std::optional<ExampleResult> run_joined(std::size_t index, Diagnostics& diagnostics);

  Example program_;
  std::vector<std::string> versions_;
  const Lesson& lesson_;
  WorkerContext& worker_context_;
  bool was_joined_ = false;
  std::optional<CompiledExample> joined_;
};

}  // namespace mjcourse
