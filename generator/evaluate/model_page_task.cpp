#include "evaluate/model_page_task.h"

#include "evaluate/bench.h"
#include "evaluate/recipe.h"

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

}  // namespace mjcourse
