// The data that the templates of a knowledge check are fed with; their own comments describe it.
// Tested by tests/generator/page/blocks/page_writer_test.cpp.
#pragma once

#include "page/blocks/lesson_context.h"

namespace mjcourse {

// `index` is the block's. The check joins the list of contents.
nlohmann::json quiz_data(const Quiz& quiz, std::size_t index, LessonContext& context);

// All that the lesson's knowledge checks ask, each as question.hbs wants it.
nlohmann::json questions_data(LessonContext& context);

}  // namespace mjcourse
