// Formulas: TeX to markup. A formula that KaTeX doubts is an error at its place.
#pragma once

#include <optional>

#include "evaluate/context/worker_context.h"
#include "findings/result.h"

namespace mjcourse {

std::optional<FormulaResult> evaluate_formula(const Math& math, const Lesson& lesson,
                                              WorkerContext& worker_context,
                                              Diagnostics& diagnostics);

}  // namespace mjcourse
