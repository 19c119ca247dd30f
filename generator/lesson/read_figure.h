// ```figure: a picture of a simulation, as JSON.
#pragma once

#include <optional>

#include "lesson/block.h"
#include "lesson/fence.h"
#include "lesson/lesson_reader.h"

namespace mjcourse {

// Nothing when the body is no JSON or names no model; else a figure without what was wrong in it.
std::optional<Figure> read_figure(Fence& fence, LessonReader& reader);

}  // namespace mjcourse
