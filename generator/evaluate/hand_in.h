// Hand-ins: what somebody wrote into the region of an exercise, compiled, run and judged.
//
// It is a stranger's: of all that was handed in, only the region's text is taken, and it runs as
// confined as a lesson's program. It shares a process with the checks, so it is refused where it
// names what belongs to them. What stands behind the region has lines that begin at another random
// number in each run, and a check counts only from its own line. So a forged one would have to find
// that number in the machine code; the file of reports cannot be read.
// Enter at ExerciseJudge.
// Tested by tests/system/grade.mjs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evaluate/context/run_context.h"
#include "evaluate/evaluate.h"
#include "evaluate/programs/exercise.h"

namespace mjcourse {

// An exercise as hand-ins are held against it.
struct JudgedExercise {
  const Lesson* lesson;
  const Exercise* exercise;
  ExerciseFiles files;
  std::vector<Check> shown, hidden;  // those of the solution, in their order
  std::vector<std::string> sources;  // what its programs are made of (ExampleResult::files)
};

struct Verdict {
  // As the exercise has them, each with what this text made of it. One that was not made fails.
  std::vector<Check> shown, hidden;
  // Why the text has no checks, or none that count: it does not compile, does not end …
  Diagnostics faults;
  std::string output = {};  // of the program that its reader knows

  bool holds() const;
  double points() const;
};

// Of those that hold.
double points_of(const std::vector<Check>& checks);

// Of a hand-in that has nothing to be run.
Verdict nothing_made(const JudgedExercise& exercise);

class ExerciseJudge {
 public:
  // Both outlive it.
  ExerciseJudge(const Course& course, const EvaluationSettings& settings);

  // Why nothing can be run here; nothing where it can.
  std::optional<Diagnostic> why_nothing_runs() const;

  // Runs the solution. Nothing (reported) where that is not as it should be.
  std::optional<JudgedExercise> prepare(const Lesson& lesson, const Exercise& exercise,
                                        Diagnostics& diagnostics) const;

  // `code` is what stands in the region. Faults are at their places in the program with that text
  // in it, whose path is `name`. With `hidden`, those checks are made, too. From any thread.
  Verdict judge(const JudgedExercise& exercise, const std::string& code, const std::string& name,
                bool hidden) const;

 private:
  RunContext run_context_;
};

}  // namespace mjcourse
