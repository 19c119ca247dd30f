// What a fence's first word means.
// Tested by tests/generator/lesson/blocks/fence_test.cpp.
// Tested by tests/courses/fence.
#pragma once

#include <optional>

#include "lesson/blocks/block.h"
#include "lesson/blocks/fence.h"
#include "lesson/blocks/lesson_reader.h"

namespace mjcourse {

// Reports that the fence is never closed; false where it is.
bool refuse_unclosed(const Fence& fence, Reading& reading);

// The block of a fence that is neither an output (read_output.h) nor a demo (read_demo.h). Nothing
// (reported) where it makes none.
std::optional<Block> read_fence(Fence& fence, LessonReader& reader);

}  // namespace mjcourse
