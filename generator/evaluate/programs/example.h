// Examples: a lesson's programs, compiled and run as its reader would.
//
// Steps: the text is compiled with `#line`, so that the compiler's complaints name the lesson. The
// program runs in an empty folder of its own, with no input, against the clock. Its stdout is the
// result, and so is what it reported to its lesson.
#pragma once

#include <optional>

#include "evaluate/context/worker_context.h"
#include "findings/result.h"
#include "lesson/blocks/lesson.h"
#include "report/diagnostic.h"

namespace mjcourse {

// `code` is all of the program (evaluate/programs/example_code.h).
std::optional<ExampleResult> evaluate_example(const Example& example, const LocatedText& code,
                                              const Lesson& lesson, WorkerContext& worker_context,
                                              Diagnostics& diagnostics);

}  // namespace mjcourse
