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
              WorkerContext& worker_context);

  // As evaluate_example() of that version.
  std::optional<ExampleResult> run(std::size_t index, Diagnostics& diagnostics);
  // Is the first of them known without compiling anything?
  bool is_known() const;
  // What it is in the page, after run(), which gave `native`.
  std::optional<PageRun> run_in_page(std::size_t index, const ExampleResult& native);

 private:
  std::optional<NativeRun> run_joined(std::size_t index);
  Example version(std::size_t index) const;

  Example program_;
  std::vector<std::string> versions_;
  const Lesson& lesson_;
  WorkerContext& worker_context_;
  std::optional<LocatedText> text_;      // all versions as one program
  std::optional<NativeProgram> joined_;  // nothing where that does not work, for whatever reason
};

}  // namespace mjcourse
