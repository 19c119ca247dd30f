// Knowledge checks: each answer found again by building what the question describes, or among what
// an example reported.
#pragma once

#include <optional>

#include "evaluate/context/worker_context.h"
#include "findings/result.h"

namespace mjcourse {

// Nothing when an answer is wrong or a proof fails; both are reported.
std::optional<QuestionResult> evaluate_question(const Question& question, const Lesson& lesson,
                                                WorkerContext& worker_context,
                                                Diagnostics& diagnostics);

}  // namespace mjcourse
