// Outputs: what the lesson says an example prints, held against what it printed.
// Tested by tests/generator/evaluate/programs/example_test.cpp.
#pragma once

#include <optional>

#include "findings/result.h"
#include "lesson/blocks/lesson.h"
#include "report/diagnostic.h"

namespace mjcourse {

std::optional<OutputResult> evaluate_output(const Output& output, const ExampleResult& example,
                                            const Lesson& lesson, Diagnostics& diagnostics);

}  // namespace mjcourse
