// Models that a lesson shows: excerpts of the course's, and whole ones of its own.
#pragma once

#include <optional>

#include "evaluate/context/worker_context.h"
#include "findings/result.h"
#include "lesson/blocks/lesson.h"
#include "report/diagnostic.h"

namespace mjcourse {

// Is this a part of the model's file? Line by line, whatever their indentation; a line that is `…`
// or a comment with `…` in it stands for any lines. The model must compile.
std::optional<ModelResult> evaluate_excerpt(const ModelExcerpt& excerpt, const Lesson& lesson,
                                            WorkerContext& worker_context,
                                            Diagnostics& diagnostics);

// Does this model compile, or not, as the lesson says?
std::optional<ModelResult> evaluate_inline_model(const InlineModel& model, const Lesson& lesson,
                                                 WorkerContext& worker_context,
                                                 Diagnostics& diagnostics);

}  // namespace mjcourse
