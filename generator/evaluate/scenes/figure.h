// Figures: the state reached, the picture drawn, and the film of what comes next.
#pragma once

#include <optional>

#include "evaluate/context/worker_context.h"
#include "findings/result.h"

namespace mjcourse {

// Nothing (reported) where a figure could not be drawn. One with a film that could not be made, or
// with a picture that differs from its reference, is reported and given all the same.
std::optional<FigureResult> evaluate_figure(const Figure& figure, const Lesson& lesson,
                                            WorkerContext& worker_context,
                                            Diagnostics& diagnostics);

}  // namespace mjcourse
