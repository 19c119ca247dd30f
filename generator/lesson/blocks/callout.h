// Callouts: a quote that begins with `[!kind] Title`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lesson/blocks/block.h"
#include "lesson/syntax/reading.h"

namespace mjcourse {

// The kinds a callout can have: the course's own and GitHub's five.
const std::vector<std::string>& callout_kinds();

// If the quote `node` is a callout, take the `[!kind]` and the title out of it (its children are
// then the body) and return it. An unknown kind is reported and leaves a plain quote.
std::optional<Callout> take_callout(cmark_node* node, Reading& reading);

// What stands behind "Source:" in the last such paragraph of `callout`, and where that leads; ""
// without one.
std::string source_in(cmark_node* callout);

}  // namespace mjcourse
