// Definition: where what is named at a place is: a model's file, a program's, a heading, a term of
// the glossary.
// Tested by tests/lsp/sessions.mjs.
#pragma once

#include "lsp/asked.h"

namespace mjcourse {

// The protocol's Location; null where nothing is named.
nlohmann::json definition_at(const Asked& asked);

}  // namespace mjcourse
