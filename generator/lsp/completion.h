// Completion: what could be written at a place, as an editor shows it.
// Tested by tests/lsp/sessions.mjs.
#pragma once

#include "lsp/asked.h"

namespace mjcourse {

nlohmann::json completion_at(const Asked& asked);

}  // namespace mjcourse
