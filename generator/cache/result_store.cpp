#include "cache/result_store.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/sha256.h"
#include "cache/stored_json.h"

namespace mjcourse {
namespace {

using nlohmann::json;
using Pairs = std::vector<std::pair<std::string, std::string>>;

// Of a model that is changed back and forth, as many versions are remembered. Each costs a reader a
// look at all the files that it names.
constexpr std::size_t kMostLists = 8;

// Of lists and of results, which a shared store has side by side.
std::string hash_of_all(std::string_view kind, const Dependencies& recipe,
                        const Dependencies& traced = {}) {
  Sha256 hash;
  hash.add(kind);
  for (const Dependencies* part : {&recipe, &traced}) {
    hash.add(std::to_string(part->size()));
    for (const Dependency& one : *part) hash.add(one.name).add(one.value);
  }
  return hash.hex();
}

std::string name_of_lists(const Dependencies& recipe) {
  return "list/" + hash_of_all("recipe", recipe);
}

std::string name_of_result(const Dependencies& recipe, const Dependencies& traced) {
  return "ac/" + hash_of_all("result", recipe, traced);
}

std::vector<std::vector<std::string>> lists_in(const std::optional<Stored>& entry) {
  using Lists = std::vector<std::vector<std::string>>;
  if (!entry) return {};
  auto lists = stored_json<Lists>(std::string_view(entry->bytes)).value_or(Lists{});
  lists.resize(std::min(lists.size(), kMostLists));  // a shared store may say more
  return lists;
}

// One line.
std::string text_of(const Dependencies& recipe, const Dependencies& traced) {
  json all = json::array();
  for (const Dependencies* part : {&recipe, &traced}) {
    for (const Dependency& one : *part) all.push_back({one.name, one.value});
  }
  return all.dump(-1, ' ', true, json::error_handler_t::replace);
}

}  // namespace

Dependency ResultStore::now(const std::string& name) {
  return {name, DependencySets::is_name(name) ? sets_.known(name) : fingerprints_.of(name)};
}

bool ResultStore::still_hold(const Dependencies& traced) {
  return std::ranges::all_of(traced, [&](const Dependency& one) {
    const bool is_set = DependencySets::is_name(one.name);
    return (is_set ? sets_.now(one.name) : fingerprints_.of(one.name)) == one.value;
  });
}

Dependencies ResultStore::known(const Names& names) {
  Dependencies found;
  for (const std::string& name : names) found.push_back(now(name));
  return found;
}

std::optional<ResultStore::Found> ResultStore::find_with(const Dependencies& recipe,
                                                         const Names& names) {
  Dependencies traced = known(names);
  std::string name = name_of_result(recipe, traced);
  std::optional<Stored> entry = store_.find(name);
  const std::string question = text_of(recipe, traced) + "\n";
  if (!entry || !entry->bytes.starts_with(question)) return std::nullopt;  // no answer to this one
  entry->bytes.erase(0, question.size());
  return Found{std::move(name), std::move(entry->bytes), std::move(traced),
               std::move(entry->origin)};
}

std::optional<ResultStore::Found> ResultStore::find(const Dependencies& recipe) {
  const std::string lists = name_of_lists(recipe);
  const std::vector<Names> own = lists_in(store_.find(lists));
  for (const Names& names : own) {
    if (auto found = find_with(recipe, names)) return found;
  }
  for (const Names& names : lists_in(store_.find_of_others(lists))) {
    if (std::ranges::find(own, names) != own.end()) continue;
    if (auto found = find_with(recipe, names)) return found;
  }
  return std::nullopt;
}

std::optional<ResultStore::Kept> ResultStore::keep(const Dependencies& recipe, const Trace& trace,
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
  for (const auto& [folder, headers] : trace.headers()) {
    names.push_back(sets_.name_of(folder, headers));
    sets_.now(names.back());
    if (!fingerprints_.tree_unchanged_since(folder, begin)) return std::nullopt;
  }
  // What was found in place of work belongs to what was there when it was found.
  const Dependencies& found = trace.found();
  if (!still_hold(found)) return std::nullopt;
  for (const auto& [name, value] : found) {
    const bool is_known = std::ranges::find(names, name) != names.end();
    if (DependencySets::is_name(name) && !is_known) names.push_back(name);
  }
  // In one order, whether the work was done or found.
  std::ranges::sort(names, {}, [](const std::string& name) {
    return std::pair(DependencySets::is_name(name), name);
  });
  const Dependencies traced = known(names);
  for (const std::string& name : looked_at_all) {
    if (!fingerprints_.unchanged_since(name, begin)) return std::nullopt;
  }
  Kept kept{name_of_result(recipe, traced), traced};
  const std::string entry = text_of(recipe, traced) + "\n" + std::string(bytes);
  if (!store_.keep(kept.name, entry, trace.origin())) return kept;
  add_list(name_of_lists(recipe), std::move(names));
  return kept;
}

// Those of others who were as quick stay there.
void ResultStore::add_list(const std::string& name, Names newest) {
  std::vector<Names> lists{std::move(newest)};
  Origin origin;
  for (const auto& entry : {store_.find(name), store_.find_of_others(name)}) {
    if (entry) origin.add(entry->origin);
    for (Names& names : lists_in(entry)) {
      if (std::ranges::find(lists, names) == lists.end()) lists.push_back(std::move(names));
    }
  }
  lists.resize(std::min(lists.size(), kMostLists));
  store_.keep(name, json(lists).dump(), origin);
}

void ResultStore::put_list(const Dependencies& recipe, const Dependencies& traced) {
  Names names;
  for (const Dependency& one : traced) names.push_back(one.name);
  add_list(name_of_lists(recipe), std::move(names));
}

Dependencies ResultStore::dependencies_of(const std::string& name) const {
  const std::string entry = store_.get(name).value_or("");
  const auto known = stored_json<Pairs>(std::string_view(entry).substr(0, entry.find('\n')));
  Dependencies found;
  for (const auto& [file, value] : known.value_or(Pairs{})) found.push_back({file, value});
  return found;
}

}  // namespace mjcourse
