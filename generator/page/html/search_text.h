// What the search finds of a lesson: its sections, as text with all markup gone.
//
// Enter at search_sections. Inline values are the numbers that the build computed. Formulas set in
// a line are as a reader sees them (formula_text.h). Formulas that stand alone, the answers of
// questions and what a demo becomes are left out. Code, with what it prints, is kept apart, since
// it counts less than words.
#pragma once

#include <string>
#include <vector>

#include "findings/lesson_results.h"
#include "lesson/blocks/lesson.h"

namespace mjcourse {

struct SearchSection {
  std::string title, anchor;  // both empty for what stands before the first heading
  std::string text, code;     // each stretch of blanks as one
};

std::vector<SearchSection> search_sections(const Lesson& lesson, const LessonResults& results);

}  // namespace mjcourse
