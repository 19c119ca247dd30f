#include "evaluate/commands_task.h"

#include <utility>

#include "base/stopwatch.h"
#include "evaluate/context/recipe.h"
#include "evaluate/programs/commands.h"

namespace mjcourse {

std::string CommandsTask::name() const {
  return "commands-" + std::to_string(block_number(lesson(), block()));
}

Dependencies CommandsTask::recipe(const RunContext& run_context) const {
  std::vector<std::string> text{commands().code.text, std::to_string(commands().seconds)};
  for (const LocatedText& file : commands().files) text.push_back(file.text);
  // They may draw, or ask which processor this is.
  return with_drawing(recipe_of(run_context, "commands", text));
}

bool CommandsTask::work(WorkerContext& worker_context, Finding& finding) {
  const Stopwatch stopwatch;
  auto result = evaluate_commands(commands(), lesson(), worker_context, finding.diagnostics);
  if (!result) return false;
  finding.results[block()] = *std::move(result);
  finding.seconds[block()] = stopwatch.seconds();
  return true;
}

}  // namespace mjcourse
