// The page of a lesson: its text, between what leads to it and what leads on.
#pragma once

#include <cstddef>
#include <string>

#include "page/page_press.h"

namespace mjcourse {

// The body of the page of `lesson`, lesson `index` of the course, which `writer` writes.
std::string lesson_page(const SiteData& site, const Lesson& lesson, std::size_t index,
                        PageWriter& writer, Templates& templates);

}  // namespace mjcourse
