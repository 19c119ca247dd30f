#include "evaluate/model_page_task.h"

#include <stdexcept>
#include <variant>

#include "evaluate/context/block_context.h"
#include "evaluate/context/recipe.h"
#include "evaluate/scenes/lab_scripts.h"
#include "evaluate/scenes/model_page.h"
#include "findings/model_page.h"

namespace mjcourse {

Dependencies ModelPageTask::recipe(const RunContext& run_context) const {
  return with_drawing(recipe_of(run_context, "model page", {name_.text}, {"world", "guard"}));
}

bool ModelPageTask::work_apart(WorkerContext& worker_context, Finding& finding) {
  Diagnostics known;
  Diagnostics& diagnostics = trouble_ == Trouble::reported ? finding.diagnostics : known;
  finding.model_page =
      evaluate_model_page(name_, BlockContext(lesson(), worker_context, diagnostics));
  return finding.model_page.has_value();
}

bool ModelPageTask::work(WorkerContext& worker_context, Finding& finding) {
  if (!finding.model_page || !finding.model_page->lab) return true;
  const Lesson& page = *finding.model_page->lab->lesson;
  LabScripts& scripts = finding.model_page->lab->result.scripts;
  if (guard_scripts(std::get<Lab>(page.blocks.at(0)), page, worker_context, scripts)) return true;
  throw std::runtime_error("the model's lab was rehearsed with a script that no page runs");
}

}  // namespace mjcourse
