#include "evaluate/task_store.h"

#include <utility>

#include "evaluate/result_fits.h"

namespace mjcourse {
bool TaskStore::find(const Task& task, TaskRecord& record, bool noted) {
  if (record.recipe.empty()) return false;
  std::optional<ResultStore::Found> found = results_.find(record.recipe);
  if (!found) return false;
  std::optional<Finding> finding = codec_.decode(found->bytes, task.block());
  if (!finding || finding->model_page.has_value() == task.model().empty() ||
      !fits(task, *finding, root_)) {
    return false;
  }
  record.traced = std::move(found->traced);
  record.origin = std::move(found->origin);
  // What was said when the task was prepared, stays said.
  finding->diagnostics = std::move(record.finding.diagnostics);
  record.finding = *std::move(finding);
  record.reused = true;
  if (noted) last_run_.note(task, found->name);
  record.result = std::move(found->name);
  return true;
}

void TaskStore::keep(const Task& task, const Trace& trace,
                     std::chrono::system_clock::time_point begin, TaskRecord& record) {
  if (record.recipe.empty()) return;
  const std::optional<std::string> bytes = codec_.encode(record.finding, task.block());
  if (!bytes) return;
  if (auto kept = results_.keep(record.recipe, trace, begin, *bytes)) {
    record.traced = std::move(kept->traced);
    last_run_.note(task, kept->name);
  }
}

Dependencies TaskStore::last(const Task& task) {
  const std::string result = last_run_.find(task);
  return result.empty() ? Dependencies{} : one_by_one(results_.dependencies_of(result));
}

}  // namespace mjcourse
