// FormulasTask: all formulas of a lesson, which are too many and too quick to be kept one by one.
// Tested by tests/generator/evaluate/answers/formula_test.cpp.
#pragma once

#include "evaluate/task.h"

namespace mjcourse {

class FormulasTask : public Task {
 public:
  // `block` is the first formula.
  FormulasTask(const Lesson& lesson, std::size_t page, std::size_t block)
      : Task(lesson, page, block, "set the formulas of " + lesson.number) {}

  std::vector<std::size_t> blocks() const override;
  Dependencies recipe(const RunContext& run_context) const override;
  bool work(WorkerContext& worker_context, Finding& finding) override;
};

}  // namespace mjcourse
