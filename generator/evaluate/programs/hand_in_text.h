// What the text of a hand-in must not have, as it is compiled into one program with its checks.
// Tested by tests/generator/evaluate/programs/hand_in_text_test.cpp.
#pragma once

#include <string>

#include "lesson/syntax/exercise_text.h"

namespace mjcourse {

// Why `text`, which somebody wrote into `region` of the exercise, is not run; "" where it is. It
// must stay in the region's scope, and name nothing that reports checks, or stands behind the
// region. What the solution has, a hand-in may have.
std::string refusal(const std::string& text, const ExerciseText& exercise,
                    const std::string& region);

}  // namespace mjcourse
