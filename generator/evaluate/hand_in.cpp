#include "evaluate/hand_in.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <string_view>
#include <utility>

#include "evaluate/programs/example.h"
#include "evaluate/programs/hand_in_text.h"

namespace mjcourse {
namespace {

// From which line on the rest of a program is counted where its solution runs; in a run of a
// hand-in it is a number that nobody knows before.
constexpr int kRestLine = 2'000'000;

int random_line() {
  std::random_device device;
  return std::uniform_int_distribution(2 * kRestLine, 500 * kRestLine)(device);
}

// Was it made by the program's own lines? These are the ones behind the region, and before it, that
// on which the solution's run made it.
bool is_own(const Check& made, const Check& known, int rest, int lines) {
  return (made.line >= rest && made.line < rest + lines) ||
         (made.line < kRestLine && made.line == known.line);
}

// `program`, of which a compiler counts what stands behind its region from `rest` on.
std::string with_rest_at(const std::string& program, const std::string& region, int rest) {
  const std::size_t end = behind_region(program, region).value();
  return program.substr(0, end) + "#line " + std::to_string(rest) + "\n" + program.substr(end);
}

// As if none had been made.
std::vector<Check> none_of(std::vector<Check> checks) {
  for (Check& check : checks) {
    check = {check.what, false, "it was not reached", "", check.points, check.line};
  }
  return checks;
}

// Runs the programs of an exercise with a text in their region.
class Judging {
 public:
  Judging(const JudgedExercise& exercise, WorkerContext& worker_context)
      : exercise_(exercise), worker_context_(worker_context) {}

  // Each of `known` with what the run of `program`, whose text is `text`, made of it.
  std::vector<Check> run(const Example& program, const std::string& text,
                         const std::vector<Check>& known, Verdict& verdict) const {
    const int rest = random_line();
    Diagnostics found;
    Example strange = program;
    strange.handed_in = true;
    const auto result =
        evaluate_example(strange, {with_rest_at(text, program.region->text, rest), {}},
                         *exercise_.lesson, worker_context_, found);
    std::vector<Check> checks = none_of(known);
    const auto lines = static_cast<int>(std::ranges::count(text, '\n'));
    if (!result) {
      std::erase_if(found, [](const Diagnostic& one) { return one.severity != Severity::error; });
      verdict.faults.insert(verdict.faults.end(), found.begin(), found.end());
      return checks;
    }
    if (verdict.output.empty()) verdict.output = result->output;
    for (const Check& made : result->records.checks) {
      const auto is = std::ranges::find(checks, made.what, &Check::what);
      if (is == checks.end()) continue;
      if (!is_own(made, *is, rest, lines)) {
        verdict.faults.push_back(
            error_at({}, "E-hand-in", "a check was not made by the program itself"));
        return none_of(known);
      }
      is->holds = made.holds;
      is->meaning = made.meaning;
      is->found = made.found;
    }
    return checks;
  }

 private:
  const JudgedExercise& exercise_;
  WorkerContext& worker_context_;
};

}  // namespace

double points_of(const std::vector<Check>& checks) {
  return std::accumulate(checks.begin(), checks.end(), 0.0, [](double sum, const Check& check) {
    return sum + (check.holds ? check.points : 0);
  });
}

double Verdict::points() const {
  return points_of(shown) + points_of(hidden);
}

bool Verdict::holds() const {
  return faults.empty() && std::ranges::all_of(shown, &Check::holds) &&
         std::ranges::all_of(hidden, &Check::holds);
}

Verdict nothing_made(const JudgedExercise& exercise) {
  return {none_of(exercise.shown), none_of(exercise.hidden), {}};
}

ExerciseJudge::ExerciseJudge(const Course& course, const EvaluationSettings& settings)
    : run_context_(course, settings.root, settings.assets, settings.helper, settings.prepared,
                   settings.script_bundles, settings.without_landlock) {}

std::optional<Diagnostic> ExerciseJudge::why_nothing_runs() const {
  if (auto why = run_context_.why_nothing_runs()) return why;
  return run_context_.compiler() ? std::nullopt : std::optional(no_compiler());
}

std::optional<JudgedExercise> ExerciseJudge::prepare(const Lesson& lesson, const Exercise& exercise,
                                                     Diagnostics& diagnostics) const {
  WorkerContext worker_context(run_context_);
  auto files = read_exercise_files(exercise, lesson, worker_context, diagnostics);
  if (!files) return std::nullopt;
  JudgedExercise judged{&lesson, &exercise, *std::move(files), {}, {}, {}};
  const auto run = [&](const Example& program, const std::string& text,
                       std::vector<Check>& checks) {
    const std::string placed = with_rest_at(text, program.region->text, kRestLine);
    auto result = evaluate_example(program, {placed, {}}, lesson, worker_context, diagnostics);
    if (!result) return false;
    checks = std::move(result->records.checks);
    judged.sources.insert(judged.sources.end(), result->files.begin(), result->files.end());
    report_failing_checks(program, {placed, {}}, checks, lesson, diagnostics);
    return std::ranges::all_of(checks, &Check::holds);
  };
  const ExerciseText& text = judged.files.text;
  if (!run(exercise.program, text.program(text.solution()), judged.shown)) return std::nullopt;
  if (exercise.hidden &&
      !run(hidden_program(exercise), hidden_text(exercise, judged.files, text.solution()),
           judged.hidden)) {
    return std::nullopt;
  }
  // Those of both programs.
  std::ranges::sort(judged.sources);
  const auto [end, last] = std::ranges::unique(judged.sources);
  judged.sources.erase(end, last);
  return judged;
}

Verdict ExerciseJudge::judge(const JudgedExercise& exercise, const std::string& code,
                             const std::string& name, bool hidden) const {
  WorkerContext worker_context(run_context_);
  Verdict verdict = nothing_made(exercise);
  if (!hidden) verdict.hidden.clear();
  const ExerciseText& text = exercise.files.text;
  if (const std::string why = refusal(code, text, exercise.exercise->program.region->text);
      !why.empty()) {
    verdict.faults.push_back(error_at({}, "E-hand-in", why));
  } else {
    const Judging judging(exercise, worker_context);
    verdict.shown =
        judging.run(exercise.exercise->program, text.program(code), exercise.shown, verdict);
    if (hidden && exercise.exercise->hidden && verdict.faults.empty()) {
      verdict.hidden = judging.run(hidden_program(*exercise.exercise),
                                   hidden_text(*exercise.exercise, exercise.files, code),
                                   exercise.hidden, verdict);
    }
  }
  // The hand-in's reader knows nothing of the lesson's text.
  for (Diagnostic& fault : verdict.faults) {
    fault.notes.clear();
    if (fault.place.file == exercise.exercise->program.file.text) {
      fault.place.file = name;
    } else {
      fault.place = {name, 0, 0, 1, "", 1};
    }
  }
  return verdict;
}

}  // namespace mjcourse
