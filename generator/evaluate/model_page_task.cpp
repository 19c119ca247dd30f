#include "evaluate/model_page_task.h"

#include <stdexcept>
#include <variant>

#include "evaluate/context/bench.h"
#include "evaluate/context/recipe.h"
#include "evaluate/scenes/lab_scripts.h"
#include "evaluate/scenes/model_page.h"
#include "findings/model_page.h"

namespace mjcourse {

Dependencies ModelPageTask::recipe(const Setting& setting) const {
  return recipe_of(setting, "model page", {name_.text}, {"world", "guard"});
}

bool ModelPageTask::work_apart(Workshop& workshop, Finding& finding) {
  Diagnostics known;
  Diagnostics& diagnostics = trouble_ == Trouble::reported ? finding.diagnostics : known;
  finding.model_page = evaluate_model_page(name_, Bench(lesson(), workshop, diagnostics));
  return finding.model_page.has_value();
}

bool ModelPageTask::work(Workshop& workshop, Finding& finding) {
  if (!finding.model_page || !finding.model_page->lab) return true;
  const Lesson page = lesson_of_lab(*finding.model_page);
  LabScripts& scripts = finding.model_page->lab->result.scripts;
  if (guard_scripts(std::get<Lab>(page.blocks.at(0)), page, workshop, scripts)) return true;
  throw std::runtime_error("the model's lab was rehearsed with a script that no page runs");
}

}  // namespace mjcourse
