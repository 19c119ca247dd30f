// Inline values: what a code span of the text asks of a model or of an example, as it is printed.
#pragma once

#include <optional>

#include "evaluate/context/workshop.h"
#include "findings/result.h"

namespace mjcourse {

// Nothing when there is no such value, or none that can stand in a text; it is reported.
std::optional<ValueResult> evaluate_value(const InlineValue& value, const Lesson& lesson,
                                          Workshop& workshop, Diagnostics& diagnostics);

}  // namespace mjcourse
