// ModelPageTask: what the page of a model tells.
// Tested by tests/generator/evaluate/scenes/model_page_test.cpp.
#pragma once

#include "evaluate/task.h"

namespace mjcourse {

class ModelPageTask : public Task {
 public:
  // Of a model that is wrong, the task that simulates it tells; not so of one that is only linked
  // to.
  enum class Trouble { reported, known };

  // `lesson` is the first to link to it or to show it, there as `name`.
  ModelPageTask(const Lesson& lesson, std::size_t page, LocatedText name, Trouble trouble)
      : Task(lesson, page, 0, "draw the model " + name.text),
        name_(std::move(name)),
        trouble_(trouble) {}

  std::vector<std::size_t> blocks() const override { return {}; }
  std::string model() const override { return name_.text; }
  bool draws() const override { return true; }
  double effort() const override { return 0.2; }
  Dependencies recipe(const RunContext& run_context) const override;
  bool is_apart() const override { return true; }
  bool work_apart(WorkerContext& worker_context, Finding& finding) override;
  bool work(WorkerContext& worker_context, Finding& finding) override;

 private:
  LocatedText name_;
  Trouble trouble_;
};

}  // namespace mjcourse
