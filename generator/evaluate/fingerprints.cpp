#include "evaluate/fingerprints.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/files.h"
#include "base/sha256.h"
#include "evaluate/dependency.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::system_clock;

// The kernel's clock for files goes in ticks of up to 10 ms.
constexpr auto kTick = std::chrono::milliseconds(12);

Clock::time_point changed_at(const struct stat& status) {
  const auto since = std::chrono::seconds(status.st_ctim.tv_sec) +
                     std::chrono::nanoseconds(status.st_ctim.tv_nsec);
  return Clock::time_point(std::chrono::duration_cast<Clock::duration>(since));
}

bool same(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino && a.st_size == b.st_size &&
         changed_at(a) == changed_at(b);
}

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
  // Whoever opens a pipe or a device would wait for it.
  const auto bytes = S_ISREG(status.st_mode) ? DiskFiles("").read(path.string())
                                             : tl::unexpected(std::string("no regular file"));
  return bytes ? sha256(*bytes) : "unreadable";
}

}  // namespace

std::optional<std::string> KnownFiles::find(const std::string& path, const struct stat& status) {
  const std::lock_guard lock(mutex_);
  const auto known = seen_.find(path);
  if (known == seen_.end() || !same(known->second.status, status)) return std::nullopt;
  known->second.looked_at = Clock::now();
  return known->second.fingerprint;
}

std::optional<std::string> KnownFiles::find_fresh(const std::string& path) const {
  const std::lock_guard lock(mutex_);
  const auto known = seen_.find(path);
  const bool fresh = known != seen_.end() && Clock::now() - known->second.looked_at < patience_;
  return fresh ? std::optional(known->second.fingerprint) : std::nullopt;
}

void KnownFiles::keep(const std::string& path, const struct stat& status,
                      const std::string& fingerprint) {
  // A change within the same tick would not show.
  if (std::chrono::system_clock::now() - changed_at(status) <= kTick) return;
  const std::lock_guard lock(mutex_);
  seen_[path] = {status, fingerprint, Clock::now()};
}

Fingerprints::Fingerprints(const fs::path& root, std::shared_ptr<KnownFiles> files)
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
  std::string found = fingerprint(path, status);
  files_->keep(path.string(), status, found);
  return found;
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
  return changed_at(status) + kTick < begin;
}

}  // namespace mjcourse
