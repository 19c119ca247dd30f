// ```LANGUAGE unchecked: what a reader has to see and no build can run.
#pragma once

#include <string>
#include <vector>

#include "lesson/blocks/block.h"
#include "lesson/blocks/fence.h"
#include "lesson/syntax/reading.h"

namespace mjcourse {

// The languages that a lesson can only show, but for commands (read_commands.h); C++, MJCF and text
// can always be checked.
const std::vector<std::string>& unchecked_languages();

// Does `unchecked` stand behind the language?
bool is_unchecked(const Fence& fence);

// `because="…"` says why nobody runs it.
Unchecked read_unchecked(Fence& fence, Reading& reading);

// A fence of one of these languages that does not say `unchecked`.
void refuse_plain(const Fence& fence, Reading& reading);

}  // namespace mjcourse
