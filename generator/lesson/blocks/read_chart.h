// Reading a ```plot fence: whose table it shows and what is said of it. Its spec is Vega-Lite's
// language; whether it is well said is found out by those who draw it.
#pragma once

#include <optional>

#include "lesson/blocks/chart.h"
#include "lesson/blocks/fence.h"
#include "lesson/blocks/lesson_reader.h"

namespace mjcourse {

// Nothing (reported) when the fence holds no JSON object.
std::optional<Chart> read_chart(Fence& fence, LessonReader& reader);

}  // namespace mjcourse
