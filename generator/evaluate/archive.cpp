#include "evaluate/archive.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "base/sha256.h"

namespace mjcourse {

bool Archive::find(const Task& task, TaskRecord& record, bool noted) {
  if (record.recipe.empty()) return false;
  std::optional<ResultStore::Found> found = results_.find(record.recipe);
  if (!found) return false;
  std::optional<Finding> finding = codec_.decode(found->bytes, task.block());
  if (!finding) return false;
  record.traced = std::move(found->traced);
  // What was said when the task was prepared, stays said.
  finding->diagnostics = std::move(record.finding.diagnostics);
  record.finding = *std::move(finding);
  record.reused = true;
  if (noted) remember(task, record);
  return true;
}

void Archive::keep(const Task& task, const Trace& trace,
                   std::chrono::system_clock::time_point begin, TaskRecord& record) {
  if (record.recipe.empty()) return;
  const std::optional<std::string> bytes = codec_.encode(record.finding, task.block());
  if (!bytes) return;
  if (auto traced = results_.keep(record.recipe, trace, begin, *bytes)) {
    record.traced = *std::move(traced);
    remember(task, record);
  }
}

// A question about this folder, and not about what is in it: only for who asks what has changed.
std::string Archive::last_name(const Task& task) const {
  const std::string& lesson = task.lesson().source->path();
  return "ac/" + Sha256().add("last").add(root_.string()).add(lesson).add(task.name()).hex();
}

void Archive::remember(const Task& task, const TaskRecord& record) {
  nlohmann::json all = nlohmann::json::array();
  for (const Dependencies* part : {&record.recipe, &record.traced}) {
    for (const Dependency& one : *part) all.push_back({one.name, one.value});
  }
  const std::string name = last_name(task), text = all.dump();
  if (store_.get(name) != text) store_.put(name, text);
}

Dependencies Archive::last(const Task& task) {
  Dependencies found;
  const std::string text = store_.get(last_name(task)).value_or("[]");
  for (const nlohmann::json& one : nlohmann::json::parse(text)) {
    found.push_back({one.at(0), one.at(1)});
  }
  return one_by_one(found);
}

}  // namespace mjcourse
