#include "evaluate/claims/claim_sources.h"

#include <algorithm>
#include <string_view>

#include "base/content_hash.h"
#include "cache/dependency.h"
#include "physics/model_files.h"

namespace mjcourse {

namespace fs = std::filesystem;

namespace {

// What stands between a quotation mark and the next one, be it inside a quotation or between two.
std::vector<std::string_view> quoted_in(std::string_view text) {
  std::vector<std::string_view> quoted;
  for (auto mark = text.find('"'); mark != text.npos;) {
    const auto next = text.find('"', mark + 1);
    if (next != text.npos) quoted.push_back(text.substr(mark + 1, next - mark - 1));
    mark = next;
  }
  return quoted;
}

// All of `text` before each place where `end` stands in it.
std::vector<std::string_view> before_each(std::string_view end, std::string_view text) {
  std::vector<std::string_view> found;
  for (auto at = text.find(end); at != text.npos; at = text.find(end, at + 1)) {
    found.push_back(text.substr(0, at));
  }
  return found;
}

}  // namespace

std::string hash_of(const std::vector<std::string>& parts) {
  std::string all;
  for (const std::string& part : parts) all += std::to_string(part.size()) + ":" + part;
  return content_hash(all);
}

std::string ClaimSources::of(const fs::path& file) {
  return fingerprints_.of(file_dependency(fs::absolute(file), root_));
}

std::string ClaimSources::model(const std::string& name) {
  if (std::find(models_.begin(), models_.end(), name) == models_.end()) return "";
  const std::lock_guard lock(mutex_);
  const auto [known, is_new] = known_.try_emplace(name);
  if (is_new) known->second = read_model(name);
  return known->second;
}

std::string ClaimSources::read_model(const std::string& name) {
  const fs::path file = root_ / "models" / (name + ".xml");
  std::vector<std::string> parts{of(file)};
  if (const auto sources = find_model_sources(root_, "models/" + name + ".xml")) {
    for (const auto* group : {&sources->texts, &sources->assets}) {
      for (const auto& [called, path] : *group) parts.insert(parts.end(), {called, of(path)});
    }
  }
  return hash_of(parts);
}

std::string ClaimSources::models_named_in(const std::string& text) {
  // Of one text for each claim, so it is gone through once and not once for each model.
  const std::vector<std::string_view> quoted = quoted_in(text), files = before_each(".xml", text);
  std::vector<std::string> parts;
  for (const std::string& name : models_) {
    const bool named = std::ranges::count(quoted, name) > 0 ||
                       std::ranges::any_of(files, [&](auto file) { return file.ends_with(name); });
    if (named) parts.push_back(model(name));
  }
  return hash_of(parts);
}

std::string ClaimSources::helper() {
  const std::lock_guard lock(mutex_);
  if (!helper_) helper_ = read_helper();
  return *helper_;
}

std::string ClaimSources::files(const std::vector<std::string>& paths) {
  std::vector<std::string> parts;
  for (const std::string& path : paths) {
    parts.insert(parts.end(), {path, of(root_ / path)});
  }
  return hash_of(parts);
}

std::string ClaimSources::read_helper() {
  std::vector<std::string> parts;
  for (const fs::path& folder : include_) {
    std::vector<fs::path> files;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, none)) {
      if (entry.is_regular_file()) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
      parts.push_back(file.lexically_relative(folder).string());
      parts.push_back(of(file));
    }
  }
  return hash_of(parts);
}

}  // namespace mjcourse
