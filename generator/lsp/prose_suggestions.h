// What could be written outside of JSON: in the text, and behind the marks of a fence.
// Tested by tests/lsp/sessions.mjs.
#pragma once

#include "lsp/asked.h"
#include "lsp/prose_place.h"
#include "lsp/suggestions.h"

namespace mjcourse {

Suggestions prose_suggestions(const Asked& asked, const ProsePlace& place);

}  // namespace mjcourse
