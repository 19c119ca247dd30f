// Charts: what the spec of a ```plot makes of a table that an example reported.
#pragma once

#include <cstddef>
#include <optional>

#include "evaluate/result.h"
#include "evaluate/workshop.h"
#include "lesson/lesson.h"
#include "report/diagnostic.h"

namespace mjcourse {

// The chart at `index` of the lesson's blocks, drawn. Nothing when its table is not there, or the
// spec is not well made; it is reported, but for a table whose example failed, which was.
std::optional<ChartResult> evaluate_chart(const Chart& chart, std::size_t index,
                                          const Lesson& lesson, Workshop& workshop,
                                          Diagnostics& diagnostics);

}  // namespace mjcourse
