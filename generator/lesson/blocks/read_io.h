// ```io: the INPUT / PROCESS / OUTPUT panel.
#pragma once

#include <optional>

#include "lesson/blocks/block.h"
#include "lesson/blocks/fence.h"
#include "lesson/blocks/lesson_reader.h"

namespace mjcourse {

// Nothing (reported) when a line has no label.
std::optional<Io> read_io(Fence& fence, LessonReader& reader);

}  // namespace mjcourse
