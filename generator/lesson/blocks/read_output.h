// ```text: what a program prints, as the lesson states it.
#pragma once

#include "lesson/blocks/fence.h"
#include "lesson/blocks/lesson.h"
#include "lesson/syntax/reading.h"

namespace mjcourse {

// Adds the output in `fence`, which is `node`, to `lesson`, and to the block that prints it: the
// one that the fence names, or the example, snippet or commands just above. A paragraph "Output:"
// may stand between.
void read_output(cmark_node* node, const Fence& fence, Lesson& lesson, Reading& reading);

}  // namespace mjcourse
