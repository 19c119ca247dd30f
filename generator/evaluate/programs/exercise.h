// Exercises: what a reader is to write, proved both ways.
//
// The solution is a program like any other, and runs as one (evaluate/program_task.h). Here it is
// handed in as a student would (version_runs.h), and passes; so are the starter, which fails a
// check, and the mistakes, each of which fails the check that is to refuse it, and no other.
//
// Tested by tests/courses/exercise.
#pragma once

#include <optional>
#include <string>

#include "evaluate/programs/exercise_files.h"
#include "findings/result.h"
#include "lesson/blocks/lesson.h"
#include "report/diagnostic.h"

namespace mjcourse {

std::optional<ExerciseResult> evaluate_exercise(const Exercise& exercise,
                                                const ExerciseFiles& files, const Lesson& lesson,
                                                WorkerContext& worker_context,
                                                Diagnostics& diagnostics);

// What the starter is in the page, after evaluate_exercise(). Nothing where it or a mistake comes
// out otherwise there (reported).
std::optional<PageRun> evaluate_exercise_in_page(const Exercise& exercise,
                                                 const ExerciseFiles& files, const Lesson& lesson,
                                                 WorkerContext& worker_context,
                                                 Diagnostics& diagnostics);

// Is it likely that evaluate_exercise() compiles nothing?
bool is_known(const Exercise& exercise, const ExerciseFiles& files, const Lesson& lesson,
              WorkerContext& worker_context);

// The checks of `program` that do not hold though it is the solution; their lines are those of its
// text, `code`.
void report_failing_checks(const Example& program, const LocatedText& code,
                           const std::vector<Check>& checks, const Lesson& lesson,
                           Diagnostics& diagnostics);

// What the solution's run adds to `result`, and a warning for each check that nothing fails.
void add_solution(const Exercise& exercise, const ExampleResult& solution, const Lesson& lesson,
                  ExerciseResult& result, Diagnostics& diagnostics);

}  // namespace mjcourse
