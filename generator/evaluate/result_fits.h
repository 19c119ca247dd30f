// Whether a result that was found before can be shown in a block as it is now.
//
// Writing a block goes through its parts and those of its result together, so what a store or a
// former edition has of it must have the same parts.
#pragma once

#include "evaluate/result.h"
#include "lesson/block.h"

namespace mjcourse {

bool fits(const Block& block, const Result& result);

}  // namespace mjcourse
