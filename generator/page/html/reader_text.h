// What a reader sees of Markdown with all markup gone: for titles and tooltips, which take no HTML.
// Tested by tests/generator/page/html/search_text_test.cpp.
#pragma once

#include <string>

#include "findings/lesson_results.h"
#include "findings/result.h"
#include "lesson/blocks/lesson.h"

namespace mjcourse {

// Of `node` in `page`, with the values that its build computed and its formulas (formula_text.h),
// each stretch of blanks as one.
std::string reader_text(cmark_node* node, const Lesson& page, const LessonResults& results);

// The same of a heading, whose lesson may be unloaded.
std::string reader_text(const Heading& heading, const LessonResults& results);

// Of a formula that may have no result, since it was not set.
std::string text_of_formula(const FormulaResult* result, const std::string& tex);

}  // namespace mjcourse
