// The state that a figure shows: the model's own, a keyframe's or an example's, and what a script
// and time make of it.
// Tested by tests/courses/figure.
#pragma once

#include <optional>

#include "evaluate/context/block_context.h"

namespace mjcourse {

// Nothing (reported) where the model, the script, the snapshot or the simulation fails.
std::optional<Simulation> simulate_figure(const Figure& figure, const BlockContext& context);

// Go on by `steps`; false (reported at `blamed`) where that leads to trouble.
bool step_on(Simulation& simulation, int steps, Span blamed, const BlockContext& context);

}  // namespace mjcourse
