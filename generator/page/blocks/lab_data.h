// The data that the template of a lab is fed with; its own comment describes it.
#pragma once

#include "page/blocks/lesson_context.h"

namespace mjcourse {

// `index` is the block's. What the lab needs beside the page joins the context's files.
nlohmann::json lab_data(const Lab& lab, std::size_t index, LessonContext& context);

}  // namespace mjcourse
