// ```cpp: a program, a region of one, or the body of a function.
#pragma once

#include <optional>

#include "lesson/blocks/block.h"
#include "lesson/blocks/fence.h"
#include "lesson/syntax/reading.h"

namespace mjcourse {

// Nothing (reported) where the fence does not say which of these it is.
std::optional<Block> read_code(Fence& fence, Reading& reading);

}  // namespace mjcourse
