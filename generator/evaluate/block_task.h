// BlockTask: a block that is found out about by itself: a lab, a figure, a plot, a quiz, a value, a
// listing of a model, an image.
// Tested by tests/generator/evaluate/evaluate_test.cpp.
#pragma once

#include "evaluate/task.h"

namespace mjcourse {

class BlockTask : public Task {
 public:
  BlockTask(const Lesson& lesson, std::size_t page, std::size_t block);

  // Is the lesson's block of such a kind?
  static bool takes(const Lesson& lesson, std::size_t block);

  std::string name() const override;
  std::vector<std::string> quoted() const override;
  bool draws() const override;
  double effort() const override;
  Dependencies recipe(const RunContext& run_context) const override;
  bool is_apart() const override;
  bool work_apart(WorkerContext& worker_context, Finding& finding) override;
  bool work(WorkerContext& worker_context, Finding& finding) override;

 private:
  bool find_out(WorkerContext& worker_context, Finding& finding) const;

  const Block& block_;
};

}  // namespace mjcourse
