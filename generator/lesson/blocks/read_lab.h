// ```lab simlab: an interactive simulation, as JSON.
#pragma once

#include <optional>

#include "lesson/blocks/block.h"
#include "lesson/blocks/fence.h"
#include "lesson/blocks/lesson_reader.h"

namespace mjcourse {

// Nothing when the body is no JSON or names no model; else a lab without what was wrong in it.
std::optional<Lab> read_lab(Fence& fence, LessonReader& reader);

}  // namespace mjcourse
