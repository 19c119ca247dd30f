// A model page's lab as the one block of a lesson.
//
// The page is written as a lesson's is, and what a lab's result must have is known from its fence.
// Tested by tests/generator/evaluate/scenes/model_lab_test.cpp.
#pragma once

#include <string>

#include "lesson/blocks/lesson.h"

namespace mjcourse {

// Of the model `name`, whose page has the lab in `fence`. Its mistakes are no author's: a caller
// decides what they mean.
Lesson lesson_of_lab(const std::string& name, const std::string& fence, Diagnostics& mistakes);

}  // namespace mjcourse
