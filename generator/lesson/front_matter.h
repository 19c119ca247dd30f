// Front matter: the YAML between two `---` lines at a lesson's start.
#pragma once

#include <optional>

#include "lesson/blocks/lesson.h"
#include "lesson/blocks/lesson_reader.h"

namespace mjcourse {

// The span of the YAML between the `---` lines; nothing (reported) when there is none.
std::optional<Span> find_front_matter(Reading& reading);

FrontMatter read_front_matter(Span span, LessonReader& reader);
// The same of a page that is no lesson, which has no other keys.
FrontMatter read_title_and_summary(Span span, LessonReader& reader);

}  // namespace mjcourse
