// Which numbers the lessons of a course have, and which the next one gets.
//
// A file that nothing lists yet has its number as well, so nobody gets it twice.
// Tested by tests/generator/cli/new_part_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "base/files.h"
#include "cli/course_file.h"
#include "course/lesson_name.h"

namespace mjcourse {

class LessonNumbers {
 public:
  // Both must outlive this.
  LessonNumbers(const Files& course, const CourseFile& file) : course_(course), file_(file) {}

  // What stands before the point in the numbers of a level: its own number, or the letter of its
  // lessons; in a level without either, the first letter that no other level has.
  std::string letter_of(const ListedLevel& level) const;
  // The name that a lesson called `slug` would have in the level.
  LessonName next(const ListedLevel& level, const std::string& slug) const;
  // The level in which lessons are numbered as `name`; null where there is none.
  const ListedLevel* level_of(const LessonName& name) const;
  // "1-state/1.2-other" that has the number of `name`; "" where none has.
  std::string taken_by(const LessonName& name) const;

 private:
  std::vector<LessonName> lessons_of(const ListedLevel& level) const;

  const Files& course_;
  const CourseFile& file_;
};

}  // namespace mjcourse
