// Footnotes of a lesson: `[^name]`, and `[^name]: …`.
// Tested by tests/courses/text.
// Tested by tests/courses/demo.
#pragma once

#include <set>
#include <string>

#include "lesson/syntax/markdown.h"
#include "lesson/syntax/reading.h"
#include "lesson/syntax/source_cursor.h"

namespace mjcourse {

using FootnoteNames = std::set<std::string>;

// cmark moves footnotes to the end of the tree, where they stand by their first mention. So each is
// looked for from where it begins in `text`, which stands in the source line for line where it is
// `in_document`.
SourceCursor begin_of_footnote(cmark_node* node, const LocatedText& text, bool in_document,
                               const SourceText& source);

// cmark sees to the names of one document; a demo is one of its own, on the same page, whose other
// footnotes have these `names`.
void refuse_second_footnote(cmark_node* node, FootnoteNames& names, Reading& reading);

// Its mark `node` in a link or a heading.
void refuse_footnote_in_link(cmark_node* node, SourceCursor cursor, Reading& reading);

}  // namespace mjcourse
