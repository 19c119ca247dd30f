// CommandsTask: the commands of one fence.
// Tested by tests/generator/evaluate/programs/commands_test.cpp.
#pragma once

#include "evaluate/task.h"

namespace mjcourse {

class CommandsTask : public Task {
 public:
  CommandsTask(const Lesson& lesson, std::size_t page, std::size_t block)
      : Task(lesson, page, block, "run commands of " + lesson.number) {}

  std::string name() const override;
  double effort() const override { return 5; }  // they may well build something
  Dependencies recipe(const RunContext& run_context) const override;
  bool work(WorkerContext& worker_context, Finding& finding) override;

 private:
  const Commands& commands() const { return std::get<Commands>(lesson().blocks[block()]); }
};

}  // namespace mjcourse
