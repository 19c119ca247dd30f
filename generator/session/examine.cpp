#include "session/examine.h"

#include <iterator>
#include <utility>

#include "base/files.h"
#include "course/theme.h"

namespace mjcourse {

Evaluation examine(const Course& course, const EvaluationSettings& settings, Progress& progress,
                   Diagnostics found) {
  Evaluation evaluation = evaluate(course, settings, progress, std::move(found));
  if (!settings.shard.is_first()) return evaluation;
  Diagnostics theme = check_theme(DiskFiles(settings.root), settings.assets);
  std::ranges::move(theme, std::back_inserter(evaluation.diagnostics));
  return evaluation;
}

}  // namespace mjcourse
