// One question of a knowledge check.
#pragma once

#include <optional>

#include "lesson/json_value.h"
#include "lesson/lesson_reader.h"
#include "lesson/quiz.h"

namespace mjcourse {

// Nothing when it cannot be asked or judged.
std::optional<Question> read_question(const JsonValue& value, LessonReader& reader);

}  // namespace mjcourse
