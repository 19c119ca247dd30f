#include "cache/dependency_sets.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "base/sha256.h"
#include "cache/stored_json.h"

namespace mjcourse {
namespace {

using nlohmann::json;
using FilesWithHashes = std::vector<std::pair<std::string, std::string>>;

constexpr std::string_view kFiles = "files ", kHeaders = "headers in ";

// The list that is kept at this address.
template <typename List>
std::optional<List> list_at(Store& store, const std::string& address) {
  return stored_json<List>(store.get("cas/" + address));
}

}  // namespace

bool DependencySets::is_name(const std::string& dependency) {
  return dependency.starts_with(kFiles) || dependency.starts_with(kHeaders);
}

std::string DependencySets::keep(const std::string& list) {
  std::string address = sha256(list);
  store_.put("cas/" + address, list);
  return address;
}

std::string DependencySets::name_of(const std::vector<std::string>& files) {
  return std::string(kFiles) + keep(json(files).dump());
}

std::string DependencySets::name_of(const std::string& folder,
                                    const std::set<std::string>& headers) {
  return std::string(kHeaders) + folder + " " + keep(json(headers).dump());
}

std::string DependencySets::now(const std::string& name) {
  std::string value = found_now(name);
  const std::lock_guard lock(mutex_);
  known_[name] = value;
  return value;
}

std::string DependencySets::found_now(const std::string& name) {
  const std::string address = name.substr(name.rfind(' ') + 1);
  if (name.starts_with(kHeaders)) {
    const auto headers = list_at<std::set<std::string>>(store_, address);
    const std::string folder = name.substr(0, name.rfind(' ')).substr(kHeaders.size());
    return headers ? fingerprints_.headers_in(folder, *headers) : kAbsent;
  }
  const auto files = list_at<std::vector<std::string>>(store_, address);
  if (!files) return kAbsent;
  json found = json::array();
  for (const std::string& file : *files) found.push_back({file, fingerprints_.of(file)});
  return keep(found.dump());
}

std::string DependencySets::known(const std::string& name) {
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = known_.find(name); known != known_.end()) return known->second;
  }
  // Many who ask at once wait for one who reads hundreds of files.
  const std::lock_guard reading(reading_);
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = known_.find(name); known != known_.end()) return known->second;
  }
  return now(name);
}

Dependencies DependencySets::one_by_one(const Dependencies& dependencies) {
  Dependencies all;
  for (const Dependency& one : dependencies) {
    const auto files =
        is_name(one.name) ? list_at<FilesWithHashes>(store_, one.value) : std::nullopt;
    if (!files) {
      all.push_back(one);
      continue;
    }
    for (const auto& [file, hash] : *files) all.push_back({file, hash});
  }
  return all;
}

}  // namespace mjcourse
