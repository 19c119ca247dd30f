#include "evaluate/file_sets.h"

#include <nlohmann/json.hpp>

#include "base/sha256.h"

namespace mjcourse {
namespace {

using nlohmann::json;

constexpr std::string_view kPrefix = "files ";

// The list that is kept at this address; null where there is none.
json list_at(Store& store, const std::string& address) {
  const auto bytes = store.get("cas/" + address);
  return bytes ? json::parse(*bytes, nullptr, false) : json();
}

}  // namespace

bool FileSets::is_name(const std::string& dependency) {
  return dependency.starts_with(kPrefix);
}

std::string FileSets::keep(const std::string& list) {
  std::string address = sha256(list);
  store_.put("cas/" + address, list);
  return address;
}

std::string FileSets::name_of(const std::vector<std::string>& files) {
  return std::string(kPrefix) + keep(json(files).dump());
}

std::string FileSets::now(const std::string& name) {
  const json files = list_at(store_, name.substr(kPrefix.size()));
  if (!files.is_array()) return kAbsent;
  json found = json::array();
  for (const std::string file : files) found.push_back({file, fingerprints_.of(file)});
  std::string value = keep(found.dump());
  const std::lock_guard lock(mutex_);
  known_[name] = value;
  return value;
}

std::string FileSets::known(const std::string& name) {
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = known_.find(name); known != known_.end()) return known->second;
  }
  return now(name);
}

Dependencies FileSets::one_by_one(const Dependencies& dependencies) {
  Dependencies all;
  for (const Dependency& one : dependencies) {
    const json files = is_name(one.name) ? list_at(store_, one.value) : json();
    if (!files.is_array()) {
      all.push_back(one);
      continue;
    }
    for (const json& file : files) all.push_back({file.at(0), file.at(1)});
  }
  return all;
}

}  // namespace mjcourse
