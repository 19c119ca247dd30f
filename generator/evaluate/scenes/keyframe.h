// A keyframe that a lesson names.
// Tested by tests/generator/evaluate/scenes/rehearsal_test.cpp.
#pragma once

#include "evaluate/context/block_context.h"

namespace mjcourse {

// Puts `simulation` into it; false (reported) where the model has no such keyframe.
bool reset_to(const LocatedText& keyframe, Simulation& simulation, const BlockContext& context);

}  // namespace mjcourse
