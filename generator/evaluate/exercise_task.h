// ExerciseTask: the starter and the wrong variants of an exercise, compiled and run. Its solution
// is the work of a ProgramTask.
// Tested by tests/courses/exercise.
#pragma once

#include <optional>

#include "evaluate/programs/exercise.h"
#include "evaluate/task.h"

namespace mjcourse {

class ExerciseTask : public Task {
 public:
  ExerciseTask(const Lesson& lesson, std::size_t page, std::size_t block)
      : Task(lesson, page, block, "try the exercise " + exercise_of(lesson, block).program.name()) {
  }

  double effort() const override { return 3; }
  bool compiles() const override { return true; }
  std::vector<std::string> warm_roots(const RunContext& run_context) const override;
  Dependencies recipe(const RunContext& run_context) const override;
  bool prepare(WorkerContext& worker_context, Finding& finding) override;
  bool work(WorkerContext& worker_context, Finding& finding) override;
  bool is_compiled(WorkerContext& worker_context) const override;
  bool work_in_page(WorkerContext& worker_context, const Finding* native,
                    Finding& finding) override;

 private:
  static const Exercise& exercise_of(const Lesson& lesson, std::size_t block) {
    return std::get<Exercise>(lesson.blocks[block]);
  }
  const Exercise& exercise() const { return exercise_of(lesson(), block()); }

  std::optional<ExerciseFiles> files_;
};

}  // namespace mjcourse
