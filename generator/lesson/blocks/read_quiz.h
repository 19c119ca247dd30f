// ```quiz: a knowledge check, as JSON.
#pragma once

#include <optional>

#include "lesson/blocks/block.h"
#include "lesson/blocks/fence.h"
#include "lesson/blocks/lesson_reader.h"

namespace mjcourse {

// Nothing when the body is no JSON; else a quiz without what was wrong in it.
std::optional<Quiz> read_quiz(Fence& fence, LessonReader& reader);

}  // namespace mjcourse
