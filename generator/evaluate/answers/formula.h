// Formulas: TeX to markup. A formula that KaTeX doubts is an error at its place.
#pragma once

#include <optional>

#include "evaluate/context/workshop.h"
#include "findings/result.h"

namespace mjcourse {

std::optional<FormulaResult> evaluate_formula(const Math& math, const Lesson& lesson,
                                              Workshop& workshop, Diagnostics& diagnostics);

}  // namespace mjcourse
