// The plan: all that is to be found out about a course, as tasks.
// Tested by tests/generator/evaluate/result_fits_test.cpp.
#pragma once

#include <memory>
#include <vector>

#include "course/course.h"
#include "evaluate/task.h"

namespace mjcourse {

using Tasks = std::vector<std::unique_ptr<Task>>;

// One task for each program that is shown whole, and one for each that is shown in regions alone.
// One for the snippets of a lesson, and one for its formulas. One for each block that is worked on
// by itself, and one for each model that a page links to. In the course's order.
Tasks plan_tasks(const Course& course);

}  // namespace mjcourse
