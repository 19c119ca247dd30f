// A site for a class that hands in its own solutions: it has none of the course's, in no page,
// file, zip or index. What their programs print, the text may still quote.
// Tested by tests/site/without-solutions.mjs.
#pragma once

#include <set>
#include <string>

#include "course/course.h"
#include "findings/evaluation.h"

namespace mjcourse {

// The files of programs of which readers write a region.
std::set<std::string> exercise_programs(const Course& course);

// Takes the solution callouts, with all that stands in them, out of what is shown; and wherever it
// stands, what shows a program of `programs`.
void withhold_solutions(Lesson& lesson, const std::set<std::string>& programs);
// Of all lessons, with what was found out about them.
void withhold_solutions(Course& course, Evaluation& evaluation);

}  // namespace mjcourse
