// What a lab asks of its reader, tried out: the prediction is measured, the goal reached by its
// solution, the numbers of an edited model computed.
#pragma once

#include "evaluate/scenes/lab_run.h"

namespace mjcourse {

// Both report what fails. At the start, with `run` as a reset leaves it: the goal is not reached
// yet, and the tasks have numbers. False where something could not be computed.
bool check_at_start(const LabContext& context, LabRun& run);
void evaluate_assignment(const LabContext& context, LabResult& result);

}  // namespace mjcourse
