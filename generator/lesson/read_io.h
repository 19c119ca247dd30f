// ```io: the INPUT / PROCESS / OUTPUT panel.
#pragma once

#include <optional>

#include "lesson/block.h"
#include "lesson/fence.h"
#include "lesson/lesson_reader.h"

namespace mjcourse {

// Nothing (reported) when a line has no label.
std::optional<Io> read_io(Fence& fence, LessonReader& reader);

}  // namespace mjcourse
