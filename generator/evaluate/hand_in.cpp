#include "evaluate/hand_in.h"

#include <algorithm>
#include <utility>

#include "evaluate/programs/version_runs.h"
#include "toolchain/warm_header.h"

namespace mjcourse {
namespace {

// From so many programs on, a header that takes ten times as long is worth it.
constexpr std::size_t kThoroughFrom = 100;

// One of the programs of an exercise, which a hand-in's text goes into.
struct Program {
  Example example;
  std::string text;  // with the text in it
  const Answers& answers;
};

std::string in_marks(const JudgedExercise& judged, const std::string& code, const JudgeKey& key) {
  return marked_code(key, code, judged.files.text.code_line(), judged.exercise->program.file.text);
}

Program shown_program(const JudgedExercise& judged, const std::string& code, const JudgeKey& key) {
  return {judged.exercise->program, judged.files.text.numbered_program(in_marks(judged, code, key)),
          judged.shown};
}

std::optional<Program> program_with_hidden(const JudgedExercise& judged, const std::string& code,
                                           const JudgeKey& key) {
  if (!judged.exercise->hidden) return std::nullopt;
  return Program{hidden_program(*judged.exercise),
                 hidden_text(*judged.exercise, judged.files, in_marks(judged, code, key)),
                 judged.hidden};
}

void keep_errors(Diagnostics& diagnostics) {
  std::erase_if(diagnostics, [](const Diagnostic& one) { return one.severity != Severity::error; });
}

}  // namespace

bool Verdict::holds() const {
  return faults.empty() && std::ranges::all_of(shown, &JudgedCheck::holds) &&
         std::ranges::all_of(hidden, &JudgedCheck::holds);
}

Verdict nothing_made(const JudgedExercise& exercise) {
  return {exercise.shown.not_reached(), exercise.hidden.not_reached(), {}};
}

ExerciseJudge::ExerciseJudge(const Course& course, const EvaluationSettings& settings, JudgeKey key)
    : run_context_(course, settings.root, settings.assets, settings.helper, settings.prepared,
                   settings.script_bundles, settings.without_landlock),
      key_(std::move(key)) {}

std::optional<Diagnostic> ExerciseJudge::why_nothing_runs() const {
  if (auto why = run_context_.why_nothing_runs()) return why;
  return run_context_.compiler() ? std::nullopt : std::optional(no_compiler());
}

// Many programs that include the same are to be compiled.
void ExerciseJudge::warm_up(const std::string& program, bool optimize, std::size_t texts) const {
  const Compiler& compiler = *run_context_.compiler();
  const auto roots = warm_roots(program, run_context_.include_folders());
  if (optimize || !compiler.makes_headers() || compiler.has_header(roots)) return;
  compiler.make_header(roots, texts < kThoroughFrom ? Warmth::quick : Warmth::thorough);
}

std::optional<JudgedExercise> ExerciseJudge::prepare(const Lesson& lesson, const Exercise& exercise,
                                                     std::size_t texts,
                                                     Diagnostics& diagnostics) const {
  WorkerContext worker_context(run_context_);
  auto files = read_exercise_files(exercise, lesson, worker_context, diagnostics);
  if (!files) return std::nullopt;
  const Place place = place_of(*lesson.source, exercise.span);
  auto rules = hand_in_rules(files->text, run_context_.compiler()->toolchain());
  if (!rules) {
    diagnostics.push_back(error_at(place, "E-exercise-hand-in",
                                   "the exercise cannot be handed in: " + rules.error()));
    return std::nullopt;
  }
  JudgedExercise judged{&lesson, &exercise, *std::move(files), std::move(rules->rules)};
  const std::string& solution = judged.files.text.solution();
  warm_up(judged.files.text.program(solution), exercise.program.optimize, texts);
  const auto run = [&](const Program& program, Answers& into) {
    VersionRuns runs(program.example, {program.text}, lesson, worker_context, key_);
    auto answers = runs.answers(diagnostics);
    if (!answers) return false;
    into = *std::move(answers);
    std::vector<Check> own;
    for (const auto& known : into.checks) own.push_back(known.check);
    report_failing_checks(program.example, {program.text, {}}, own, lesson, diagnostics);
    if (!into.hold()) return false;
    const auto handed_in = runs.run(0, into, diagnostics);
    if (!handed_in) return false;
    const std::vector<std::string>& opened = handed_in->result.files;
    judged.sources.insert(judged.sources.end(), opened.begin(), opened.end());
    const auto fails = std::ranges::find(handed_in->verdict, false, &JudgedCheck::holds);
    if (fails == handed_in->verdict.end()) return true;
    diagnostics.push_back(error_at(place, "E-exercise-hand-in",
                                   "the solution, handed in, fails the check `" + fails->what + "`",
                                   "what is expected must not change from run to run"));
    diagnostics.back().detail = fails->found;
    return false;
  };
  if (!run(shown_program(judged, solution, key_), judged.shown)) return std::nullopt;
  if (const auto hidden = program_with_hidden(judged, solution, key_)) {
    if (!run(*hidden, judged.hidden)) return std::nullopt;
  }
  const Program shown = shown_program(judged, solution, key_);
  if (const auto code = expanded_code(shown.example, shown.text, key_, lesson, worker_context)) {
    const auto tokens = raw_tokens({*code}, run_context_.compiler()->toolchain());
    if (tokens) judged.rules.allow_expanded(*code, tokens->front());
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
  const auto refuse = [&](const std::string& why, Place place) {
    place.file = name;
    verdict.faults.push_back(error_at(std::move(place), "E-hand-in", why));
    return verdict;
  };
  const auto found = hand_in_faults({code}, exercise.rules, run_context_.compiler()->toolchain());
  if (!found) return refuse(found.error(), {});
  if (const auto& fault = found->front()) {
    const ExerciseText& text = exercise.files.text;
    const std::size_t begin = text.code_begin();
    return refuse(fault->why, place_of(SourceText(name, text.program(code)),
                                       {begin + fault->span.begin, begin + fault->span.end}));
  }
  const auto run = [&](const Program& program, std::vector<JudgedCheck>& into) {
    Diagnostics all;
    auto ran = run_handed_in({program.example, program.text, exercise.files.text.program(code),
                              program.answers, exercise.rules, key_},
                             *exercise.lesson, worker_context, all);
    if (!ran) {
      keep_errors(all);
      verdict.faults = std::move(all);
      return;
    }
    into = std::move(ran->verdict);
    if (verdict.output.empty()) verdict.output = std::move(ran->result.output);
  };
  run(shown_program(exercise, code, key_), verdict.shown);
  const auto more = hidden ? program_with_hidden(exercise, code, key_) : std::nullopt;
  if (more && verdict.faults.empty()) {
    run(*more, verdict.hidden);
    verdict.is_hidden_fault = !verdict.faults.empty();
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
