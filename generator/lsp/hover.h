// Hover: what is known of what stands at a place: a value that was computed, an answer's proof, a
// name of MuJoCo's, a key of a lab, what a mistake means.
// Tested by tests/lsp/sessions.mjs.
#pragma once

#include "lsp/asked.h"

namespace mjcourse {

// The protocol's Hover; null where there is nothing to say.
nlohmann::json hover_at(const Asked& asked);

}  // namespace mjcourse
