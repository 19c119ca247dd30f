// Formulas: TeX to markup. A formula that KaTeX doubts is an error at its place.
#pragma once

#include <optional>

#include "evaluate/result.h"
#include "evaluate/workshop.h"

namespace mjcourse {

std::optional<FormulaResult> evaluate_formula(const Math& math, const Lesson& lesson,
                                              Workshop& workshop, Diagnostics& diagnostics);

}  // namespace mjcourse
