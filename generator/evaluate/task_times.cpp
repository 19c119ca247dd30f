#include "evaluate/task_times.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "base/sha256.h"
#include "cache/stored_json.h"

namespace mjcourse {
namespace {

using std::chrono::microseconds;

constexpr std::size_t kDigits = 16;  // of a hash: two that are alike cost a little time
std::string short_hash(const std::string& text) {
  return sha256(text).substr(0, kDigits);
}

std::string text_of(const Dependencies& recipe) {
  const auto text = std::ranges::find(recipe, "text", &Dependency::name);
  return text == recipe.end() ? "" : text->value.substr(0, kDigits);
}

microseconds rounded(double seconds) {
  constexpr double kLongest = 86400;
  return microseconds(std::llround(std::clamp(seconds, 0.0, kLongest) * 1e6));
}

// In microseconds. What differs less is not worth writing down.
bool is_about(std::int64_t now, std::int64_t before) {
  constexpr std::int64_t kLeast = 100'000;
  return std::abs(now - before) <= std::max(kLeast, before * 3 / 10);
}

}  // namespace

TaskTimes::TaskTimes(Store* store, const std::string& course)
    : store_(store), name_("list/" + Sha256().add("times").add(course).hex()) {
  if (store_ == nullptr) return;
  // All machines have those of the shared store, and each perhaps others of its own.
  auto entry = store_->find_of_others(name_);
  if (!entry) entry = store_->find(name_);
  if (!entry) return;
  origin_ = entry->origin;
  const std::string_view bytes = entry->bytes;
  if (auto known = stored_json<std::map<std::string, Known>>(bytes)) known_ = *std::move(known);
}

TaskTimes::Expected TaskTimes::of(const Task& task, const Dependencies& recipe) const {
  const auto known = known_.find(short_hash(task.name_in_course()));
  if (recipe.empty()) return {rounded(task.effort()), false};  // it is done each time
  if (known == known_.end()) return {rounded(task.effort()), true};
  const auto& [lasted, text] = known->second;
  return {std::max(microseconds(lasted), microseconds(1)), text != text_of(recipe)};
}

void TaskTimes::note(const Task& task, const Dependencies& recipe, double seconds) {
  if (recipe.empty()) return;
  const std::string name = short_hash(task.name_in_course());
  Known& noted = noted_[name] = {rounded(seconds).count(), text_of(recipe)};
  const auto known = known_.find(name);
  if (known != known_.end() && is_about(noted.first, known->second.first)) {
    noted.first = known->second.first;
  }
}

void TaskTimes::write() const {
  if (store_ == nullptr || noted_ == known_) return;
  store_->keep(name_, nlohmann::json(noted_).dump(), origin_);
}

}  // namespace mjcourse
