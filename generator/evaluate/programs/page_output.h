// What a program printed in the page, held against what it printed natively.
//
// They are compared as a lesson's output is with the run (output_diff.h), and with the tolerance
// and the `[..]` of the lesson's own.
#pragma once

#include "findings/result.h"
#include "lesson/blocks/lesson.h"
#include "report/diagnostic.h"

namespace mjcourse {

// Reports what differs in the page; says nothing of a program that no page runs.
void compare_page_run(const Example& example, const PageRun& page, const Lesson& lesson,
                      Diagnostics& diagnostics);

}  // namespace mjcourse
