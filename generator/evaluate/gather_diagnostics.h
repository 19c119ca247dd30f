// Gathering what tasks said, each by itself.
#pragma once

#include "report/diagnostic.h"

namespace mjcourse {

// Adds `found` to `all`. A mistake in a model's file is found by each task that uses the model, one
// in a header by each program that includes it; it becomes one diagnostic, with a note for each
// lesson.
void gather_diagnostics(Diagnostics found, Diagnostics& all);

}  // namespace mjcourse
