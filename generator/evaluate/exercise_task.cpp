#include "evaluate/exercise_task.h"

#include <string>
#include <utility>
#include <vector>

#include "base/cpp_includes.h"
#include "base/files.h"
#include "base/stopwatch.h"
#include "evaluate/context/recipe.h"
#include "evaluate/programs/compiled_recipe.h"
#include "toolchain/warm_header.h"

namespace mjcourse {

std::vector<std::string> ExerciseTask::warm_roots(const RunContext& run_context) const {
  if (exercise().program.optimize || !files_) return {};
  return mjcourse::warm_roots(files_->text.file().text(), run_context.include_folders());
}

Dependencies ExerciseTask::recipe(const RunContext& run_context) const {
  const Example& program = exercise().program;
  std::vector<std::string> text{program.file.text,
                                program.region->text,
                                std::string(files_->text.file().text()),
                                files_->hidden.value_or("none is hidden"),
                                program.optimize ? "optimized" : "plain",
                                program.native,
                                std::to_string(program.seconds)};
  text.insert(text.end(), program.arguments.begin(), program.arguments.end());
  Dependencies recipe = compiled_recipe(run_context, "exercise", text, program.optimize);
  return mjcourse::draws(files_->text.file().text()) ? with_drawing(std::move(recipe)) : recipe;
}

bool ExerciseTask::prepare(WorkerContext& worker_context, Finding& finding) {
  const DiskFiles files(worker_context.root());
  if (!files.read(exercise().program.file.text)) return false;  // reported as a program
  files_ = read_exercise_files(exercise(), lesson(), worker_context, finding.diagnostics);
  return files_.has_value();
}

bool ExerciseTask::work(WorkerContext& worker_context, Finding& finding) {
  const Stopwatch stopwatch;
  auto result =
      evaluate_exercise(exercise(), *files_, lesson(), worker_context, finding.diagnostics);
  if (!result) return false;
  finding.results[block()] = *std::move(result);
  finding.seconds[block()] = stopwatch.seconds();
  return true;
}

bool ExerciseTask::is_compiled(WorkerContext& worker_context) const {
  return files_ && is_known(exercise(), *files_, lesson(), worker_context);
}

bool ExerciseTask::work_in_page(WorkerContext& worker_context, const Finding*, Finding& finding) {
  auto page =
      evaluate_exercise_in_page(exercise(), *files_, lesson(), worker_context, finding.diagnostics);
  if (!page) return false;
  finding.pages[block()] = *std::move(page);
  return true;
}

}  // namespace mjcourse
