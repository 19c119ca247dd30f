#include "actions/action_store.h"

#include <utility>

#include "base/sha256.h"
#include "sources/kActionSources.h"

namespace mjcourse {
namespace {

std::string hash_of(const Dependencies& recipe) {
  Sha256 hash;
  for (const Dependency& one : recipe) hash.add(one.name).add(one.value);
  return hash.hex();
}

// Bytes are kept behind their hash. The result of an action is believed as it stands, so a damaged
// entry must be seen here.
std::string with_hash(const std::string& bytes) {
  return sha256(bytes) + bytes;
}

std::optional<std::string> without_hash(const std::string& kept) {
  const std::size_t size = 64;
  if (kept.size() < size) return std::nullopt;
  std::string bytes = kept.substr(size);
  return kept.compare(0, size, sha256(bytes)) == 0 ? std::optional(std::move(bytes)) : std::nullopt;
}

}  // namespace

std::optional<ActionStore::Known> ActionStore::remembered(const std::string& hash) {
  const std::lock_guard lock(mutex_);
  const auto known = known_.find(hash);
  return known == known_.end() ? std::nullopt : std::optional(known->second);
}

std::optional<std::string> ActionStore::find(const Dependencies& recipe, Trace& trace) {
  const std::string hash = hash_of(recipe);
  // Somebody may have saved a file since.
  auto known = remembered(hash);
  if (known && (results_ == nullptr || results_->still_hold(known->traced))) {
    trace.add(known->trace);
    return std::move(known->bytes);
  }
  if (results_ == nullptr) return std::nullopt;
  const auto found = results_->find(recipe);
  auto bytes = found ? without_hash(found->bytes) : std::nullopt;
  if (!bytes) return std::nullopt;
  Trace own(root_);
  own.found(found->traced, found->origin);
  trace.add(own);
  const std::lock_guard lock(mutex_);
  known_.insert_or_assign(hash, Known{*bytes, std::move(own), found->traced});
  return bytes;
}

void ActionStore::keep(const Dependencies& recipe, const Trace& trace,
                       std::chrono::system_clock::time_point begin, std::string bytes) {
  Known known{std::move(bytes), trace, {}};
  if (results_ != nullptr) {
    auto kept = results_->keep(recipe, trace, begin, with_hash(known.bytes));
    if (!kept) return;  // the files that it read have changed since
    known.trace = Trace(root_);
    known.trace.found(kept->traced, trace.origin());
    known.traced = std::move(kept->traced);
  }
  const std::lock_guard lock(mutex_);
  known_.insert_or_assign(hash_of(recipe), std::move(known));
}

Dependencies action_recipe(const std::string& kind, const std::vector<std::string>& text) {
  Sha256 hash;
  for (const std::string& part : text) hash.add(part);
  return {{"kind", kind},
          {"text", hash.hex()},
          {"mjcourse", std::string("sources of actions ") + kActionSources}};
}

}  // namespace mjcourse
