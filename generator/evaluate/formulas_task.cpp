#include "evaluate/formulas_task.h"

#include <string>
#include <vector>

#include "base/stopwatch.h"
#include "evaluate/answers/formula.h"
#include "evaluate/context/recipe.h"

namespace mjcourse {
namespace {

// Of a lesson's formulas: a few letters make ten thousand, by macros, and a lesson has room for
// thousands of such.
constexpr std::size_t kMostMarkup = 32 << 20;  // bytes

}  // namespace

std::vector<std::size_t> FormulasTask::blocks() const {
  return blocks_of<Math>(lesson());
}

Dependencies FormulasTask::recipe(const RunContext& run_context) const {
  std::vector<std::string> text;
  for (std::size_t i = block(); i < lesson().blocks.size(); ++i) {
    const auto* math = std::get_if<Math>(&lesson().blocks[i]);
    if (math == nullptr) continue;
    // The place among the blocks is a part of the finding.
    text.push_back(std::to_string(i - block()) + (math->display ? " display " : " ") +
                   math->tex.text);
  }
  Dependencies recipe = recipe_of(run_context, "formulas", text, {"typeset"});
  for (const auto& [name, tex] : run_context.course().macros)
    recipe.push_back({"macro " + name, tex});
  return recipe;
}

bool FormulasTask::work(WorkerContext& worker_context, Finding& finding) {
  bool whole = true;
  std::size_t markup = 0;
  for (std::size_t i = block(); i < lesson().blocks.size(); ++i) {
    const auto* math = std::get_if<Math>(&lesson().blocks[i]);
    if (math == nullptr) continue;
    const Stopwatch stopwatch;
    auto result = evaluate_formula(*math, lesson(), worker_context, finding.diagnostics);
    whole = whole && result;
    if (!result) continue;
    markup += result->markup.size();
    if (markup > kMostMarkup) {
      finding.diagnostics.push_back(
          error_at(place_of(*lesson().source, math->tex.span(0, 1)), "E-math",
                   "the formulas of this lesson are more than 32 MiB of HTML up to here",
                   "make several lessons of it, or shorten what its macros are written out to"));
      return false;
    }
    finding.results[i] = *std::move(result);
    finding.seconds[i] = stopwatch.seconds();
  }
  return whole;
}

}  // namespace mjcourse
