// The data that the templates of a lesson's other blocks are fed with; their own comments describe
// it.
// Tested by tests/generator/page/blocks/page_writer_test.cpp.
#pragma once

#include <cstddef>
#include <string>

#include "page/blocks/lesson_context.h"

namespace mjcourse {

// `index` is the block's; `inner` is the HTML of what stands in a callout.
nlohmann::json data_of(const Example& example, std::size_t index, LessonContext& context);
nlohmann::json data_of(const Exercise& exercise, const ExerciseResult& result,
                       LessonContext& context);
// Those that a reader can solve in the page, each: id, program (as the page calls it), title
// (HTML).
nlohmann::json exercises_data(const LessonContext& context);
nlohmann::json data_of(const Output& output, std::size_t index, const LessonContext& context);
nlohmann::json data_of(const Unchecked& unchecked, const LessonContext& context);
nlohmann::json data_of(const Snippet& snippet, std::size_t index, const LessonContext& context);
nlohmann::json data_of(const Commands& commands, std::size_t index, const LessonContext& context);
nlohmann::json data_of(const ModelExcerpt& excerpt, const LessonContext& context);
nlohmann::json data_of(const InlineModel& model, std::size_t index, const LessonContext& context);
nlohmann::json data_of(const Image& image, const ImageResult& result, const LessonContext& context);
nlohmann::json data_of(const Io& io, const LessonContext& context);
nlohmann::json data_of(const Demo& demo, const LessonContext& context);
nlohmann::json data_of(const Callout& callout, const std::string& inner,
                       const LessonContext& context);

}  // namespace mjcourse
