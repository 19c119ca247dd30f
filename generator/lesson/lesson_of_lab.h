// A model page's lab as the one block of a lesson: so it is rehearsed, held against what the store
// has of it, and written as every lab is.
// Tested by tests/generator/evaluate/scenes/model_lab_test.cpp.
#pragma once

#include <memory>
#include <string>

#include "lesson/blocks/lesson.h"

namespace mjcourse {

// Of the model `name`, whose page has the lab in `fence`. Where there are mistakes in it, which are
// no author's, the lesson is not `sound`.
std::shared_ptr<const Lesson> lesson_of_lab(const std::string& name, const std::string& fence);

}  // namespace mjcourse
