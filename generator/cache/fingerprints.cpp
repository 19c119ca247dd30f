#include "cache/fingerprints.h"

#include <sys/stat.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "base/files.h"
#include "base/sha256.h"
#include "cache/dependency.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::system_clock;

constexpr const char* kUnreadable = "unreadable";

std::string fingerprint(const fs::path& path, const struct stat& status) {
  if (S_ISDIR(status.st_mode)) {
    std::vector<std::string> names;
    std::error_code unreadable;
    for (const fs::directory_entry& entry : fs::directory_iterator(path, unreadable)) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    Sha256 hash;
    for (const std::string& name : names) hash.add(name);
    return hash.hex();
  }
  if (!S_ISREG(status.st_mode)) return kUnreadable;  // a device or a pipe, which may have no end
  const auto bytes = read_file(path);
  return bytes ? sha256(*bytes) : kUnreadable;
}

std::vector<fs::directory_entry> entries_below(const fs::path& folder) {
  std::vector<fs::directory_entry> entries;
  std::error_code unreadable;
  const fs::recursive_directory_iterator end;
  for (fs::recursive_directory_iterator at(folder, unreadable); !unreadable && at != end;
       at.increment(unreadable)) {
    entries.push_back(*at);
  }
  return entries;
}

}  // namespace

Fingerprints::Fingerprints(const fs::path& root, std::shared_ptr<FingerprintCache> files)
    : root_(fs::absolute(root)), files_(std::move(files)) {}

std::string Fingerprints::of(const std::string& name) {
  if (name.starts_with('/')) {
    if (auto known = files_->find_fresh(name)) return *std::move(known);
  }
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = others_.find(name); known != others_.end()) return known->second;
  }
  const fs::path path = root_ / name;
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return kAbsent;
  if (auto known = files_->find(path.string(), status)) return *std::move(known);
  // Nobody reads it; what a link leads to says nothing of the link.
  if (!name.starts_with('/') && DiskFiles(root_).refusal(name)) return kUnreadable;
  std::string found = fingerprint(path, status);
  files_->keep(path.string(), status, found);
  return found;
}

std::string Fingerprints::headers_in(const std::string& folder,
                                     const std::set<std::string>& names) const {
  std::set<std::string> found;
  for (const fs::directory_entry& entry : entries_below(root_ / folder)) {
    const std::string path = entry.path().lexically_relative(root_ / folder);
    std::error_code none;
    if (entry.is_directory(none)) {
      found.insert(path + "/");
    } else if (names.contains(entry.path().filename())) {
      found.insert(path);
    }
  }
  std::string text;
  for (const std::string& path : found) text += (text.empty() ? "" : ", ") + path;
  return text;
}

void Fingerprints::set(const std::string& name, const std::string& value) {
  const std::lock_guard lock(mutex_);
  others_[name] = value;
}

bool Fingerprints::unchanged_since(const std::string& name, Clock::time_point begin) const {
  {
    const std::lock_guard lock(mutex_);
    if (others_.contains(name)) return true;
  }
  struct stat status {};
  fs::path path = root_ / name;
  // A file that is not there was perhaps removed: then its folder has changed.
  while (stat(path.c_str(), &status) != 0) {
    if (path == path.parent_path()) return false;
    path = path.parent_path();
  }
  return changed_at(status) + tick_of(status) < begin;
}

bool Fingerprints::tree_unchanged_since(const std::string& folder, Clock::time_point begin) const {
  if (!unchanged_since(folder, begin)) return false;
  return std::ranges::all_of(entries_below(root_ / folder), [&](const fs::directory_entry& entry) {
    std::error_code none;
    return !entry.is_directory(none) || unchanged_since(entry.path(), begin);
  });
}

}  // namespace mjcourse
