// What could be written in the JSON of a lab, a quiz, a figure or a plot: keys, values, names in
// scripts.
// Tested by tests/lsp/sessions.mjs.
#pragma once

#include "lsp/asked.h"
#include "lsp/lesson_fences.h"
#include "lsp/suggestions.h"

namespace mjcourse {

Suggestions json_suggestions(const Asked& asked, const LessonFence& fence);

// What could end `before`, a piece of a script over `model`, which may be empty.
Suggestions script_suggestions(const Asked& asked, const std::string& before,
                               const std::string& model);

// A model's description, if there is one of that name or it is one itself; else "".
std::string known_model(const Asked& asked, const std::string& model);

}  // namespace mjcourse
