// Labs, rehearsed: every button pressed, every readout and trace read, without a browser.
//
// Steps: the model compiles; readouts and traces are read at rest, and the poster drawn; then each
// button is pressed on a fresh state, two seconds are simulated, and everything is read again and
// again on the way. A script that fails anywhere is an error at its place in the lesson.
#pragma once

#include <optional>

#include "evaluate/result.h"
#include "evaluate/workshop.h"

namespace mjcourse {

std::optional<LabResult> evaluate_lab(const Lab& lab, const Lesson& lesson, Workshop& workshop,
                                      Diagnostics& diagnostics);

}  // namespace mjcourse
