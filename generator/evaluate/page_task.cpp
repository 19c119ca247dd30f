#include "evaluate/page_task.h"

#include <variant>

#include "evaluate/program_task.h"
#include "evaluate/programs/compiled_recipe.h"
#include "evaluate/programs/page_output.h"
#include "findings/snippet_program.h"

namespace mjcourse {

std::optional<PageRun> PageTask::known_of(const Result& result) const {
  if (const auto* ran = std::get_if<ExampleResult>(&result)) return ran->page;
  const auto* exercise = std::get_if<ExerciseResult>(&result);
  if (exercise == nullptr || !exercise->page) return std::nullopt;
  const bool is_solution = dynamic_cast<const ProgramTask*>(native_.get()) != nullptr;
  return is_solution ? exercise->page : PageRun{exercise->why_not};
}

Dependencies PageTask::recipe(const RunContext& run_context) const {
  return with_page(native_->recipe(run_context), run_context);
}

// What it says, the task that runs natively says.
bool PageTask::prepare(WorkerContext& worker_context, Finding&) {
  Finding known;
  return native_->prepare(worker_context, known);
}

// A program that failed natively gives nothing to compare with.
bool PageTask::work(WorkerContext& worker_context, Finding& finding) {
  if (native_finding_ != nullptr && native_finding_->results.empty()) return false;
  return native_->work_in_page(worker_context, native_finding_, finding);
}

// The lesson may state more of an output than the native run printed, and is edited without that
// the program runs again.
void PageTask::conclude(WorkerContext&, Finding& finding) {
  const auto* program = dynamic_cast<const ProgramTask*>(native_.get());
  for (const auto& [index, page] : finding.pages) {
    if (program != nullptr) {  // an exercise's solution, too
      compare_page_run(program->program(), page, lesson(), finding.diagnostics);
    } else if (std::holds_alternative<Snippet>(lesson().blocks[index])) {
      compare_page_run(snippet_program(lesson(), index), page, lesson(), finding.diagnostics);
    }
  }
}

}  // namespace mjcourse
