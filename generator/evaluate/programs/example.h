// Examples: a lesson's programs, compiled and run as its reader would.
//
// The program is an action (actions/native_program.h). What it printed is the result, and so is
// what it reported to its lesson; here both are judged. What it is in the page is found out apart
// (page_run.h).
#pragma once

#include <optional>

#include "actions/native_program.h"
#include "evaluate/context/worker_context.h"
#include "findings/result.h"
#include "lesson/blocks/lesson.h"
#include "report/diagnostic.h"

namespace mjcourse {

// `code` is all of the program (evaluate/programs/example_code.h).
std::optional<ExampleResult> evaluate_example(const Example& example, const LocatedText& code,
                                              const Lesson& lesson, WorkerContext& worker_context,
                                              Diagnostics& diagnostics);

// The same of a program that is run several times: nothing is compiled yet. Nothing (reported)
// where nothing can be.
std::optional<NativeProgram> native_program(const Example& example, const LocatedText& code,
                                            const Lesson& lesson, WorkerContext& worker_context,
                                            Diagnostics& diagnostics);
// One run of it, where that was found, or else with `program` compiled. Nothing where it has to be
// compiled first.
std::optional<NativeRun> known_run(const Example& example, const NativeProgram& program);
NativeRun new_run(const Example& example, NativeProgram& program);
// What such a run gives; nothing (reported) where it went wrong.
std::optional<ExampleResult> judge_native(const Example& example, const LocatedText& code,
                                          NativeRun run, const Lesson& lesson,
                                          Diagnostics& diagnostics);

// Is its result known without compiling anything?
bool is_known(const Example& example, const LocatedText& code, const Lesson& lesson,
              WorkerContext& worker_context);

}  // namespace mjcourse
