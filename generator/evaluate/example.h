// Examples: a lesson's programs, compiled and run as its reader would.
//
// Steps: the fence and its file must be the same text; the text is compiled with `#line`, so that
// the compiler's complaints name the lesson; the program runs in an empty folder of its own, with
// no input, against the clock; its stdout is the result, and what it reported to its lesson.
#pragma once

#include <filesystem>
#include <optional>

#include "base/files.h"
#include "evaluate/compiler.h"
#include "evaluate/result.h"
#include "evaluate/shown_program.h"
#include "lesson/lesson.h"
#include "report/diagnostic.h"

namespace mjcourse {

// `root` is the course's folder, `shown` what its fences say of the file. Safe to call from several
// threads, each with its own diagnostics.
std::optional<ExampleResult> evaluate_example(const Example& example, const ShownProgram& shown,
                                              const Lesson& lesson,
                                              const std::filesystem::path& root,
                                              const Compiler& compiler, Diagnostics& diagnostics);

}  // namespace mjcourse
