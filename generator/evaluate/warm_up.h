// Make ready what the next program of a course takes longest for.
// Tested by tests/generator/session/live_session_test.cpp.
#pragma once

#include "course/course.h"
#include "evaluate/evaluate.h"

namespace mjcourse {

// The warm headers (warm_objects.h) of the course's programs, where they are not there yet; quick
// ones, as an author edits one program at a time. Throws Cancelled when the caller's work is
// cancelled.
void warm_up(const Course& course, const EvaluationSettings& settings);

}  // namespace mjcourse
