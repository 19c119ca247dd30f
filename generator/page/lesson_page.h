// The page of a lesson: its text, between what leads to it and what leads on.
// Tested by tests/generator/page/blocks/page_writer_test.cpp.
#pragma once

#include <cstddef>
#include <string>

#include "page/blocks/page_writer.h"
#include "page/site_data.h"

namespace mjcourse {

struct LessonPage {
  std::string body;     // of the page
  std::string prose;    // of that, the lesson's text
  std::string answers;  // of that, what is told behind it on paper; "" where nothing is asked
};

// The page of `lesson`, lesson `index` of the course, which `writer` writes.
LessonPage lesson_page(const SiteData& site, const Lesson& lesson, std::size_t index,
                       PageWriter& writer, Templates& templates);

}  // namespace mjcourse
