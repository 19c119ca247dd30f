// Paragraphs, headings and rows in which something is mere text that was meant otherwise.
// Tested by tests/generator/lesson/syntax/mere_text_test.cpp.
#pragma once

#include "lesson/blocks/lesson.h"
#include "lesson/syntax/located_text.h"
#include "lesson/syntax/reading.h"

namespace mjcourse {

// `text` is what `node` was parsed from: the document of the lesson, or a fragment.
void warn_of_mere_text(cmark_node* node, const LocatedText& text, bool in_document,
                       const Lesson& lesson, Reading& reading);

}  // namespace mjcourse
