// Outline: the headings of a lesson and what stands below each: programs, labs, figures, plots,
// quizzes.
#pragma once

#include <nlohmann/json.hpp>

#include "lsp/text_point.h"

namespace mjcourse {

// The protocol's list of DocumentSymbols.
nlohmann::json outline_of(const SourceText& text, Units units);

}  // namespace mjcourse
