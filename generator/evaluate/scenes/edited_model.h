// The model that a reader of an editable lab is to arrive at, as the goal's solution says.
// Tested by tests/generator/evaluate/scenes/assignment_test.cpp.
#pragma once

#include <optional>

#include "evaluate/scenes/lab_context.h"

namespace mjcourse {

// A model's name, or MJCF: the lab's own with the solution's put in, whose bytes keep their places
// in the lesson. Empty where the solution is a script; nothing (reported) where it cannot be put
// in.
std::optional<LocatedText> edited_model(const LabContext& context, const Lab::Goal& goal);

}  // namespace mjcourse
