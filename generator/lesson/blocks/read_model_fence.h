// ```xml: an excerpt of a model of the course, or a model inside the lesson.
#pragma once

#include <optional>

#include "lesson/blocks/block.h"
#include "lesson/blocks/fence.h"
#include "lesson/syntax/reading.h"

namespace mjcourse {

// Nothing (reported) where the fence does not say which of the two it is.
std::optional<Block> read_model_fence(Fence& fence, Reading& reading);

}  // namespace mjcourse
