// Labs, rehearsed: every control used, every readout and trace read, without a browser.
//
// Steps: the model compiles. Readouts and traces are read at the start. Then two seconds are
// simulated, by themselves and again after each control, and everything is read all the way
// (rehearsal.h). What is asked of the reader is tried out (assignment.h). At last the poster is
// drawn. A script that fails anywhere is an error at its place in the lesson.
#pragma once

#include <optional>

#include "evaluate/context/worker_context.h"
#include "findings/result.h"

namespace mjcourse {

// As evaluate_lab(), but without the poster.
std::optional<LabResult> rehearse_lab(const Lab& lab, const Lesson& lesson,
                                      WorkerContext& worker_context, Diagnostics& diagnostics);

std::optional<LabResult> evaluate_lab(const Lab& lab, const Lesson& lesson,
                                      WorkerContext& worker_context, Diagnostics& diagnostics);

}  // namespace mjcourse
