// SnippetsTask: all snippets of a lesson, which are one program.
// Tested by tests/generator/evaluate/programs/snippets_test.cpp.
#pragma once

#include "evaluate/task.h"

namespace mjcourse {

class SnippetsTask : public Task {
 public:
  // `block` is the first of them.
  SnippetsTask(const Lesson& lesson, std::size_t page, std::size_t block)
      : Task(lesson, page, block, "compile and run the snippets of " + lesson.number) {}

  std::vector<std::size_t> blocks() const override;
  double effort() const override { return 1; }
  bool compiles() const override { return true; }
  std::vector<std::string> warm_roots(const RunContext& run_context) const override;
  Dependencies recipe(const RunContext& run_context) const override;
  // Their models.
  bool is_apart() const override { return true; }
  bool work_apart(WorkerContext& worker_context, Finding& finding) override;
  bool work(WorkerContext& worker_context, Finding& finding) override;
  bool is_compiled(WorkerContext& worker_context) const override;
  bool work_in_page(WorkerContext& worker_context, const Finding* native,
                    Finding& finding) override;
};

}  // namespace mjcourse
