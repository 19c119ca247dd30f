// The data that the template of a figure is fed with; its own comment describes it.
#pragma once

#include "page/blocks/lesson_context.h"

namespace mjcourse {

// `index` is the block's.
nlohmann::json figure_data(const Figure& figure, std::size_t index, const LessonContext& context);

}  // namespace mjcourse
