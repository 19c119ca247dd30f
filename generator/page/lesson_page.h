// The page of a lesson: its text, between what leads to it and what leads on.
#pragma once

#include <cstddef>
#include <string>

#include "evaluate/evaluate.h"
#include "page/page_writer.h"

namespace mjcourse {

// The body of the page of lesson `index`, which `writer` writes.
std::string lesson_page(const Course& course, const Evaluation& evaluation, std::size_t index,
                        PageWriter& writer, Templates& templates);

}  // namespace mjcourse
