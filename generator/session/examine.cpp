#include "session/examine.h"

#include <iterator>
#include <utility>

#include "base/files.h"
#include "course/theme.h"

namespace mjcourse {

Evaluation examine(const Course& course, const Workplace& workplace, Progress& progress,
                   Diagnostics found) {
  Evaluation evaluation = evaluate(course, workplace, progress, std::move(found));
  Diagnostics theme = check_theme(DiskFiles(workplace.root), workplace.assets);
  std::ranges::move(theme, std::back_inserter(evaluation.diagnostics));
  return evaluation;
}

}  // namespace mjcourse
