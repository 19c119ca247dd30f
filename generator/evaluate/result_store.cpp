#include "evaluate/result_store.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/sha256.h"

namespace mjcourse {
namespace {

using nlohmann::json;

// Of a model that is changed back and forth, as many versions are remembered.
constexpr std::size_t kMostLists = 8;

std::string hash_of_all(std::string_view kind, const Dependencies& recipe,
                        const Dependencies& traced = {}) {
  Sha256 hash;
  hash.add(kind);
  for (const Dependencies* part : {&recipe, &traced}) {
    hash.add(std::to_string(part->size()));
    for (const Dependency& one : *part) hash.add(one.name).add(one.value);
  }
  return "ac/" + hash.hex();
}

}  // namespace

std::vector<ResultStore::Names> ResultStore::looked_at(const std::string& recipe) {
  const std::optional<std::string> bytes = store_.get(recipe);
  if (!bytes) return {};
  const json lists = json::parse(*bytes, nullptr, false);
  return lists.is_array() ? lists.get<std::vector<Names>>() : std::vector<Names>{};
}

Dependencies ResultStore::known(const Names& names) {
  Dependencies found;
  for (const std::string& name : names) {
    found.push_back({name, FileSets::is_name(name) ? sets_.known(name) : fingerprints_.of(name)});
  }
  return found;
}

std::optional<ResultStore::Found> ResultStore::find(const Dependencies& recipe) {
  for (const Names& names : looked_at(hash_of_all("recipe", recipe))) {
    Dependencies traced = known(names);
    if (auto bytes = store_.get(hash_of_all("result", recipe, traced))) {
      return Found{*std::move(bytes), std::move(traced)};
    }
  }
  return std::nullopt;
}

std::optional<Dependencies> ResultStore::keep(const Dependencies& recipe, const Trace& trace,
                                              std::chrono::system_clock::time_point begin,
                                              std::string_view bytes) {
  if (!trace.complete()) return std::nullopt;
  Names names(trace.names().begin(), trace.names().end());
  Names looked_at_all = names;
  for (const Names& set : trace.sets()) {
    names.push_back(sets_.name_of(set));
    sets_.now(names.back());  // what was known before the work began may be former
    looked_at_all.insert(looked_at_all.end(), set.begin(), set.end());
  }
  Dependencies traced = known(names);
  for (const std::string& name : looked_at_all) {
    if (!fingerprints_.unchanged_since(name, begin)) return std::nullopt;
  }
  if (!store_.put(hash_of_all("result", recipe, traced), bytes)) return traced;
  const std::string list = hash_of_all("recipe", recipe);
  std::vector<Names> lists = looked_at(list);
  std::erase(lists, names);
  lists.insert(lists.begin(), names);
  lists.resize(std::min(lists.size(), kMostLists));
  store_.put(list, json(lists).dump());
  return traced;
}

}  // namespace mjcourse
