// Examples: a lesson's programs, compiled and run as its reader would.
//
// Steps: the text is compiled with `#line`, so that the compiler's complaints name the lesson. The
// program runs in an empty folder of its own, with no input, against the clock. Its stdout is the
// result, and so is what it reported to its lesson.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "base/temporary_folder.h"
#include "evaluate/context/worker_context.h"
#include "findings/result.h"
#include "lesson/blocks/lesson.h"
#include "report/diagnostic.h"
#include "toolchain/compiler.h"

namespace mjcourse {

// `code` is all of the program (evaluate/programs/example_code.h).
std::optional<ExampleResult> evaluate_example(const Example& example, const LocatedText& code,
                                              const Lesson& lesson, WorkerContext& worker_context,
                                              Diagnostics& diagnostics);

// The same in two steps, for a program that is run several times.
struct CompiledExample {
  std::unique_ptr<TemporaryFolder> folder;
  LocatedText code;
  Compiled compiled;  // its messages are not reported
  std::filesystem::path binary;
  int runs = 0;
};
// Nothing (reported) where nothing can be compiled.
std::optional<CompiledExample> compile_example(const Example& example, const LocatedText& code,
                                               const Lesson& lesson, WorkerContext& worker_context,
                                               Diagnostics& diagnostics);
// `program` did compile.
std::optional<ExampleResult> run_example(const Example& example, CompiledExample& program,
                                         const Lesson& lesson, WorkerContext& worker_context,
                                         Diagnostics& diagnostics);

}  // namespace mjcourse
