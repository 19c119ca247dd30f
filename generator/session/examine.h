// Enter here for the truth about a course that was read: what its lessons state, worked out, and
// what is wrong with it beside them.
//
// `check` and `build`, the preview and the editor all come through here, so that they say the same.
// Tested by tests/courses/course.
#pragma once

#include "evaluate/evaluate.h"

namespace mjcourse {

// Its diagnostics begin with what reading the course `found` wrong. Throws Cancelled when the
// caller's work is cancelled.
Evaluation examine(const Course& course, const EvaluationSettings& settings, Progress& progress,
                   Diagnostics found);

}  // namespace mjcourse
