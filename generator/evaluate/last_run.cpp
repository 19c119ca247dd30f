#include "evaluate/last_run.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "base/sha256.h"
#include "cache/stored_json.h"

namespace mjcourse {
namespace {

using nlohmann::json;

}  // namespace

LastRun::LastRun(Store& store, const std::filesystem::path& root)
    : store_(store), name_("here/" + Sha256().add("last").add(root.string()).hex()) {}

LastRun::~LastRun() {
  // Nobody must fail here, whatever a lesson's file is called.
  if (changed_)
    store_.put(name_, json(results_).dump(-1, ' ', true, json::error_handler_t::replace));
}

void LastRun::read() {
  if (was_read_) return;
  was_read_ = true;
  auto known = stored_json<std::map<std::string, std::string>>(store_.get(name_));
  if (known) results_ = *std::move(known);
}

std::string LastRun::find(const Task& task) {
  const std::lock_guard lock(mutex_);
  read();
  const auto found = results_.find(task.name_in_course());
  return found != results_.end() ? found->second : "";
}

void LastRun::note(const Task& task, const std::string& result) {
  const std::lock_guard lock(mutex_);
  read();
  std::string& last = results_[task.name_in_course()];
  changed_ = changed_ || last != result;
  last = result;
}

}  // namespace mjcourse
