// Pairs of typed quotes, `"…"` and `'…'`, as the quotation marks of a language.
//
// cmark finds the pairs, as it does for English. This extension of it takes each pair and writes
// the marks. A quote that is none of a pair stays as cmark has it: an apostrophe, or English.
// Tested by tests/generator/lesson/syntax/markdown_test.cpp.
#pragma once

#include "lesson/syntax/syntax_pointer.h"
#include "lesson/syntax/typography.h"

namespace mjcourse {

// For a parser with CMARK_OPT_SMART. `marks` must live as long.
SyntaxPointer quote_syntax(const QuotationMarks& marks);

}  // namespace mjcourse
