// One question of a knowledge check.
#pragma once

#include <optional>

#include "lesson/blocks/lesson_reader.h"
#include "lesson/blocks/quiz.h"
#include "lesson/json/json_value.h"

namespace mjcourse {

// Nothing when it cannot be asked or judged.
std::optional<Question> read_question(const JsonValue& value, LessonReader& reader);

}  // namespace mjcourse
