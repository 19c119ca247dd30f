// Formulas of a lesson, `$…$` and `$$…$$` (math_syntax.h).
// Tested by tests/generator/lesson/syntax/math_syntax_test.cpp.
// Tested by tests/courses/math.
#pragma once

#include "lesson/blocks/block.h"
#include "lesson/syntax/markdown.h"
#include "lesson/syntax/reading.h"
#include "lesson/syntax/source_cursor.h"

namespace mjcourse {

// What is remembered from one formula to the next of a lesson.
struct MathState {
  bool is_cut = false;  // a `$$` below text was not closed
};

Math read_math(cmark_node* node, SourceCursor& cursor, MathState& state, Reading& reading);

// In a node of text: a `$$` that begins no formula. `in_document`: the node is not of a fragment.
void refuse_unclosed_math(cmark_node* text, SourceCursor cursor, bool in_document, MathState& state,
                          Reading& reading);

}  // namespace mjcourse
