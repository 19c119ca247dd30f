// The rehearsal of a lab: each control in each of its values, and everything read all the way.
#pragma once

#include <functional>
#include <vector>

#include "evaluate/scenes/lab_run.h"
#include "physics/whole_view.h"

namespace mjcourse {

// Simulate `seconds` from where `run` stands, and read everything at each frame as the page does.
// `look` is called after each reading, with the number of steps and the readouts; where it gives
// false, that was enough. False when something failed, which is reported.
bool play(LabRun& run, double seconds,
          const std::function<bool(int steps, const std::vector<double>& readouts)>& look);

// Two seconds of every control in every value, and of none, in which `view`, which may be null,
// sees all that there is. A control that fails is reported, and left out of what is given.
std::vector<LabRunResult> rehearse(const LabContext& context, WholeView* view);

}  // namespace mjcourse
