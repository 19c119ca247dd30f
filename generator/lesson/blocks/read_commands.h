// ```sh run: commands that the build runs as a reader would.
#pragma once

#include "lesson/blocks/block.h"
#include "lesson/blocks/fence.h"
#include "lesson/syntax/reading.h"

namespace mjcourse {

// Is it `sh run`?
bool is_commands(const Fence& fence);

Commands read_commands(Fence& fence, Reading& reading);

}  // namespace mjcourse
