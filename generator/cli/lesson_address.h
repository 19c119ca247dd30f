// Which lesson is meant by the words behind `new lesson`.
// Tested by tests/generator/cli/new_part_test.cpp.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "cli/lesson_numbers.h"
#include "cli/new_files.h"

namespace mjcourse {

struct LessonAddress {
  const ListedLevel* level;  // of the file
  LessonName name;
  std::string title;
};

// "2-dynamics" with a title, whose number and name are then found; "2-dynamics/2.1-forces",
// "2-dynamics/forces", "2.1-forces" or a path with or without a title.
tl::expected<LessonAddress, Refusal> lesson_address(const CourseFile& file,
                                                    const LessonNumbers& numbers,
                                                    const std::vector<std::string>& words);

}  // namespace mjcourse
