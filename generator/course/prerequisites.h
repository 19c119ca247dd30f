// Prerequisites: what a lesson's reader is assumed to have read, and what its text leans on beyond
// that.
//
// A term (`[[state]]`) or a name of MuJoCo's (`api:mj_step`) is explained where the course's order
// has it first. Its level's earlier lessons are read before a lesson, and its prerequisites, and
// what these need in turn. Where a lesson leans on what another explains, outside of those, one of
// its readers has never heard of it.
// Tested by tests/courses/prerequisite.
#pragma once

#include "course/course.h"
#include "report/diagnostic.h"

namespace mjcourse {

// W-prerequisite, once for a lesson and a lesson that it leans on. Of a course that has no
// `prerequisites`, nothing is known: it may be read from start to end. What stands beside the
// course (Level::number) and drafts explain nothing to its readers.
void warn_of_missing_prerequisites(const Course& course, Diagnostics& diagnostics);

}  // namespace mjcourse
