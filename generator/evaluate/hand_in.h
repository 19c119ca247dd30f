// Hand-ins: what somebody wrote into the region of an exercise, compiled, run and judged.
//
// It is a stranger's: of all that was handed in, only the region's text is taken, and it runs as
// confined as a lesson's program. What it finds is judged outside of its process, which does not
// know the answers (evaluate/programs/judge.h). Where a check says itself whether it holds, the
// verdict says that it does.
// Enter at ExerciseJudge.
// Tested by tests/system/grade.mjs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evaluate/context/run_context.h"
#include "evaluate/evaluate.h"
#include "evaluate/programs/exercise.h"
#include "evaluate/programs/hand_in_text.h"
#include "evaluate/programs/judge.h"
#include "evaluate/programs/judged_text.h"

namespace mjcourse {

// An exercise as hand-ins are held against it.
struct JudgedExercise {
  const Lesson* lesson;
  const Exercise* exercise;
  ExerciseFiles files;
  HandInRules rules;
  Answers shown = {}, hidden = {};
  std::vector<std::string> sources = {};  // what its programs are made of (ExampleResult::files)
};

struct Verdict {
  // As the exercise has them, each with what this text made of it. One that was not made fails.
  std::vector<JudgedCheck> shown, hidden;
  // Why the text has no checks, or none that count: it does not compile, does not end …
  Diagnostics faults;
  bool is_hidden_fault = false;  // are these of the program with the hidden checks?
  std::string output = {};       // of the program that its reader knows

  bool holds() const;
};

// Of a hand-in that has nothing to be run.
Verdict nothing_made(const JudgedExercise& exercise);

class ExerciseJudge {
 public:
  // Both outlive it.
  ExerciseJudge(const Course& course, const EvaluationSettings& settings, JudgeKey key);

  // Why nothing can be run here; nothing where it can.
  std::optional<Diagnostic> why_nothing_runs() const;

  // Runs the solution, and hands it in. Nothing (reported) where either fails. About so many
  // `texts` will be judged, which says how much is worth sharing among them.
  std::optional<JudgedExercise> prepare(const Lesson& lesson, const Exercise& exercise,
                                        std::size_t texts, Diagnostics& diagnostics) const;

  // `code` is what stands in the region. Faults are at their places in the program with that text
  // in it, whose path is `name`. With `hidden`, those checks are made, too. From any thread.
  Verdict judge(const JudgedExercise& exercise, const std::string& code, const std::string& name,
                bool hidden) const;

 private:
  void warm_up(const std::string& program, bool optimize, std::size_t texts) const;

  RunContext run_context_;
  JudgeKey key_;
};

}  // namespace mjcourse
