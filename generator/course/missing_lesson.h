// A lesson that course.yaml lists and that cannot be had: what is wrong, and what to write instead.
// Tested by tests/generator/course/read_course_test.cpp.
#pragma once

#include <string>

#include "base/files.h"

namespace mjcourse {

struct MissingLesson {
  std::string message, cure;
};

// Of `entry` among the lessons of the level in `folder`.
MissingLesson missing_lesson(const Files& files, const std::string& folder,
                             const std::string& entry);

}  // namespace mjcourse
