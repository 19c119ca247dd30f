// Links of a lesson: `[words](target)`, `[words][reference]` and `<https://…>`.
// Tested by tests/generator/lesson/read_lesson_test.cpp.
// Tested by tests/courses/link.
#pragma once

#include <cstddef>

#include "lesson/blocks/lesson.h"
#include "lesson/syntax/reading.h"
#include "lesson/syntax/source_cursor.h"

namespace mjcourse {

struct ReadLink {
  Link link;
  // Where the walk goes on behind a target that stands behind the link's words, so that it is not
  // taken for that of the next link. The target of a link by reference stands in its definition.
  std::size_t behind = 0;
};

ReadLink read_link(cmark_node* node, SourceCursor cursor, Reading& reading);

}  // namespace mjcourse
