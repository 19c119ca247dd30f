// Reference pictures: small ones that lie beside the lessons, and hold what is drawn to them.
#pragma once

#include <string>

#include "base/files.h"
#include "course/course.h"

namespace mjcourse {

// Where the picture lies that `lesson` pins as `pin`, below the course's folder.
std::string reference_path(const Lesson& lesson, const std::string& pin);

// Warn of those that no lesson pins any more. Where a lesson has a mistake, that may be why, and
// nothing is said.
void warn_of_unused_references(const Files& files, const Course& course, Diagnostics& diagnostics);

}  // namespace mjcourse
