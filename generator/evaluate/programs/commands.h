// Commands of a lesson, run by a shell as a reader would type them.
//
// The folder that they run in has the files that their fence names, and nothing else of the course:
// so what they come to depends on those, on the commands, and on what is installed.
#pragma once

#include <optional>

#include "evaluate/context/worker_context.h"
#include "findings/result.h"
#include "lesson/blocks/lesson.h"
#include "report/diagnostic.h"

namespace mjcourse {

// What they printed; nothing (reported) where a file is missing or one of them failed, behind which
// no other is run.
std::optional<ExampleResult> evaluate_commands(const Commands& commands, const Lesson& lesson,
                                               WorkerContext& worker_context,
                                               Diagnostics& diagnostics);

}  // namespace mjcourse
