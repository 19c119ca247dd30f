#include "evaluate/formulas_task.h"

#include <string>
#include <vector>

#include "base/stopwatch.h"
#include "evaluate/formula.h"
#include "evaluate/recipe.h"

namespace mjcourse {

std::vector<std::size_t> FormulasTask::blocks() const {
  return blocks_of<Math>(lesson());
}

Dependencies FormulasTask::recipe(const Setting& setting) const {
  std::vector<std::string> text;
  for (std::size_t i = block(); i < lesson().blocks.size(); ++i) {
    const auto* math = std::get_if<Math>(&lesson().blocks[i]);
    if (math == nullptr) continue;
    // The place among the blocks is a part of the finding.
    text.push_back(std::to_string(i - block()) + (math->display ? " display " : " ") +
                   math->tex.text);
  }
  Dependencies recipe = recipe_of(setting, "formulas", text, {"typeset"});
  for (const auto& [name, tex] : setting.course().macros) recipe.push_back({"macro " + name, tex});
  return recipe;
}

bool FormulasTask::work(Workshop& workshop, Finding& finding) {
  bool whole = true;
  for (std::size_t i = block(); i < lesson().blocks.size(); ++i) {
    const auto* math = std::get_if<Math>(&lesson().blocks[i]);
    if (math == nullptr) continue;
    const Stopwatch stopwatch;
    auto result = evaluate_formula(*math, lesson(), workshop, finding.diagnostics);
    whole = whole && result;
    if (!result) continue;
    finding.results[i] = *std::move(result);
    finding.seconds[i] = stopwatch.seconds();
  }
  return whole;
}

}  // namespace mjcourse
