// Examples: a lesson's programs, compiled and run as its reader would.
//
// The program is an action (actions/native_program.h). What it printed is the result, and so is
// what it reported to its lesson; here both are judged. What it is in the page is found out apart
// (page_run.h).
#pragma once

#include <optional>
#include <string>

#include "actions/native_program.h"
#include "evaluate/context/worker_context.h"
#include "findings/result.h"
#include "lesson/blocks/lesson.h"
#include "report/diagnostic.h"

namespace mjcourse {

// How a program is run, beside what its fence says.
struct RunAs {
  bool handed_in = false;  // a stranger may have written a part of it
  std::string seed = {};
  std::optional<RunListener> listener = {};
  bool is_kept = true;
};

// `code` is all of the program (evaluate/programs/example_code.h).
std::optional<ExampleResult> evaluate_example(const Example& example, const LocatedText& code,
                                              const Lesson& lesson, WorkerContext& worker_context,
                                              Diagnostics& diagnostics);

// The same of a program that is run several times: nothing is compiled yet. Nothing (reported)
// where nothing can be.
std::optional<NativeProgram> native_program(const Example& example, const LocatedText& code,
                                            const Lesson& lesson, WorkerContext& worker_context,
                                            Diagnostics& diagnostics, bool handed_in = false);
// One run of it, where that was found. Nothing where it has to be compiled first.
std::optional<NativeRun> known_run(const Example& example, const NativeProgram& program,
                                   const RunAs& as = {});
// The same, compiled where it has to be. Nothing (reported) where it does not compile.
std::optional<NativeRun> compiled_run(const Example& example, const LocatedText& code,
                                      NativeProgram& program, const Lesson& lesson,
                                      WorkerContext& worker_context, Diagnostics& diagnostics,
                                      const RunAs& as = {});
// What such a run gives; nothing (reported) where it went wrong.
std::optional<ExampleResult> judge_native(const Example& example, const LocatedText& code,
                                          NativeRun run, const Lesson& lesson,
                                          Diagnostics& diagnostics);

// Is its result known without compiling anything?
bool is_known(const Example& example, const LocatedText& code, const Lesson& lesson,
              WorkerContext& worker_context);

}  // namespace mjcourse
