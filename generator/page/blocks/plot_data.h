// The data that the template of a plot is fed with; its own comment describes it.
#pragma once

#include "page/blocks/lesson_context.h"

namespace mjcourse {

// `index` is the block's.
nlohmann::json plot_data(const Plot& plot, std::size_t index, const LessonContext& context);

}  // namespace mjcourse
