// What must hold of every lesson that was read, with errors or without.
#pragma once

#include <string>

#include "lesson/blocks/lesson.h"
#include "report/diagnostic.h"

namespace mjcourse {

// All its blocks, links and headings are where they say; what refers to a block refers to one that
// is there and of its kind.
void check_lesson(const Lesson& lesson);

// Read `bytes` as the lesson `path`, twice: what comes of it holds, and is the same.
void check_reading(const std::string& path, const std::string& bytes);

// All that was understood, for comparing.
std::string text_of(const Lesson& lesson);

}  // namespace mjcourse
