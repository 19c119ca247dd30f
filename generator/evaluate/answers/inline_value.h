// Inline values: what a code span of the text asks of a model or of an example, as it is printed.
#pragma once

#include <optional>

#include "evaluate/context/worker_context.h"
#include "findings/result.h"

namespace mjcourse {

// Nothing when there is no such value, or none that can stand in a text; it is reported.
std::optional<ValueResult> evaluate_value(const InlineValue& value, const Lesson& lesson,
                                          WorkerContext& worker_context, Diagnostics& diagnostics);

}  // namespace mjcourse
