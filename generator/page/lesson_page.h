// The page of a lesson: its text, between what leads to it and what leads on.
#pragma once

#include <cstddef>
#include <string>

#include "evaluate/evaluate.h"
#include "page/page_writer.h"

namespace mjcourse {

// The body of the page of `lesson`, lesson `index` of the course, which `writer` writes.
std::string lesson_page(const Course& course, const Evaluation& evaluation, const Lesson& lesson,
                        std::size_t index, PageWriter& writer, Templates& templates);

}  // namespace mjcourse
