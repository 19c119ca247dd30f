// Reading a ```plot fence: whose table it shows and what is said of it. Its spec is Vega-Lite's
// language; whether it is well said is found out when it is drawn.
#pragma once

#include <optional>

#include "lesson/blocks/fence.h"
#include "lesson/blocks/lesson_reader.h"
#include "lesson/blocks/plot.h"

namespace mjcourse {

// Nothing (reported) when the fence holds no JSON object.
std::optional<Plot> read_plot(Fence& fence, LessonReader& reader);

}  // namespace mjcourse
