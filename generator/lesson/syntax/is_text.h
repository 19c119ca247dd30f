// Whatever an author writes is text: UTF-8, without control characters but tabs and line ends, and
// not larger than a person writes and reads.
// Tested by tests/generator/lesson/read_lesson_test.cpp.
#pragma once

#include <string>

#include "report/diagnostic.h"

namespace mjcourse {

// False (reported; at the first byte that is none) when the file `path` is something else.
bool is_text(const std::string& path, const std::string& bytes, Diagnostics& diagnostics);

}  // namespace mjcourse
