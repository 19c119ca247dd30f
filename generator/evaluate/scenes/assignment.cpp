#include "evaluate/scenes/assignment.h"

#include <optional>
#include <sstream>
#include <string>

#include "evaluate/scenes/edited_model.h"
#include "evaluate/scenes/rehearsal.h"

namespace mjcourse {
namespace {

std::optional<double> measure(const LabContext& context, const Lab::Predict& predict) {
  std::optional<LabRun> run = LabRun::start(context, context.lab().model);
  double value = 0;
  const bool measured =
      run && (predict.run.text.empty() || run->script(predict.run, "the prediction's script")) &&
      play(*run, predict.seconds, [](int, const std::vector<double>&) { return true; }) &&
      run->number(predict.value, value);
  return measured ? std::optional(value) : std::nullopt;
}

// The text that a goal's solution is.
const LocatedText& solution_of(const Lab::Goal& goal) {
  if (!goal.solution_run.text.empty()) return goal.solution_run;
  return goal.solution_model.text.empty() ? goal.solution_insert : goal.solution_model;
}

bool compute_tasks(const LabContext& context, LabRun& run) {
  bool good = true;
  double value = 0;
  for (const Lab::Task& task : context.lab().tasks) good = run.number(task.value, value) && good;
  return good;
}

void prove_goal(const LabContext& context, const Lab::Goal& goal) {
  if (solution_of(goal).text.empty()) return;  // which was reported when it was read
  const std::optional<LocatedText> edited = edited_model(context, goal);
  if (!edited) return;
  const bool edits = !edited->text.empty();
  std::optional<LabRun> run = LabRun::start(context, edits ? *edited : context.lab().model);
  if (!run) return;
  if (edits) compute_tasks(context, *run);
  if (!edits && !run->script(goal.solution_run, "the solution")) return;
  bool done = false;
  const bool played = play(*run, goal.solution_seconds, [&](int, const std::vector<double>&) {
    return run->truth(goal.done, done) && !done;
  });
  if (!played || done) return;
  std::ostringstream message;
  message << "the solution does not reach the goal";
  if (goal.solution_seconds > 0) message << " within " << goal.solution_seconds << " s";
  context.error("E-lab-goal", solution_of(goal).span(), message.str(),
                "fix the solution, give it more \"seconds\", or ask for less in \"done\"");
}

}  // namespace

bool check_at_start(const LabContext& context, LabRun& run) {
  bool good = compute_tasks(context, run);
  if (!context.lab().goal) return good;
  const LocatedText& goal = context.lab().goal->done;
  bool done = false;
  good = run.truth(goal, done) && good;
  if (done) {
    context.error("E-lab-goal", goal.span(), "the goal is already reached at the start",
                  "ask for something that is not so from the start");
  }
  return good;
}

void evaluate_assignment(const LabContext& context, LabResult& result) {
  const Lab& lab = context.lab();
  if (lab.predict) result.predicted = measure(context, *lab.predict);
  if (lab.goal) prove_goal(context, *lab.goal);
}

}  // namespace mjcourse
