// ```figure: a picture of a simulation, as JSON.
#pragma once

#include <optional>

#include "lesson/blocks/block.h"
#include "lesson/blocks/fence.h"
#include "lesson/blocks/lesson_reader.h"

namespace mjcourse {

// Nothing when the body is no JSON or names no model; else a figure without what was wrong in it.
std::optional<Figure> read_figure(Fence& fence, LessonReader& reader);

}  // namespace mjcourse
