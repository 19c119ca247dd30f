// ProgramTask: a program of examples/, compiled and run, whether a fence shows all of it or regions
// alone.
// Tested by tests/generator/evaluate/programs/example_test.cpp.
#pragma once

#include <optional>

#include "evaluate/programs/example_code.h"
#include "evaluate/task.h"

namespace mjcourse {

class ProgramTask : public Task {
 public:
  // `program` is the block's, without code where the block shows a region: the code is the file's.
  ProgramTask(const Lesson& lesson, std::size_t page, std::size_t block, Example program)
      : Task(lesson, page, block, "compile and run " + program.name()),
        program_(std::move(program)) {}

  const Example& program() const { return program_; }

  double effort() const override { return 1; }
  bool compiles() const override { return true; }
  std::vector<std::string> warm_roots(const RunContext& run_context) const override;
  Dependencies recipe(const RunContext& run_context) const override;
  bool prepare(WorkerContext& worker_context, Finding& finding) override;
  bool work(WorkerContext& worker_context, Finding& finding) override;
  void conclude(WorkerContext& worker_context, Finding& finding) override;
  bool is_compiled(WorkerContext& worker_context) const override;
  bool work_in_page(WorkerContext& worker_context, const Finding* native,
                    Finding& finding) override;

 private:
  Example program_;
  tl::expected<std::string, std::string> file_;  // as it is on the disk
  std::optional<ExampleCode> code_;
};

}  // namespace mjcourse
