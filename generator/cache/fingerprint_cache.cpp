#include "cache/fingerprint_cache.h"

#include <sstream>
#include <utility>

#include "base/sha256.h"

namespace mjcourse {
namespace {

using SystemClock = std::chrono::system_clock;

// The kernel's clock for files goes in ticks of up to 10 ms. Some file systems know seconds alone,
// or every other one.
constexpr std::chrono::milliseconds kTick{12};
constexpr std::chrono::seconds kCoarseTick{3};

std::string name_of(const std::filesystem::path& root) {
  return "here/" + Sha256().add("files").add(std::filesystem::absolute(root).string()).hex();
}

}  // namespace

SystemClock::time_point changed_at(const struct stat& status) {
  const auto since = std::chrono::seconds(status.st_ctim.tv_sec) +
                     std::chrono::nanoseconds(status.st_ctim.tv_nsec);
  return SystemClock::time_point(std::chrono::duration_cast<SystemClock::duration>(since));
}

SystemClock::duration tick_of(const struct stat& status) {
  if (status.st_ctim.tv_nsec == 0) return kCoarseTick;
  return kTick;
}

FingerprintCache::Status FingerprintCache::status_of(const struct stat& status) {
  return {status.st_dev, status.st_ino, status.st_size,
          changed_at(status).time_since_epoch().count()};
}

std::optional<std::string> FingerprintCache::find(const std::string& path,
                                                  const struct stat& status) {
  const std::lock_guard lock(mutex_);
  const auto known = seen_.find(path);
  if (known == seen_.end() || known->second.status != status_of(status)) return std::nullopt;
  known->second.looked_at = Clock::now();
  return known->second.fingerprint;
}

std::optional<std::string> FingerprintCache::find_fresh(const std::string& path) const {
  const std::lock_guard lock(mutex_);
  const auto known = seen_.find(path);
  const bool fresh = known != seen_.end() && known->second.looked_at &&
                     Clock::now() - *known->second.looked_at < patience_;
  return fresh ? std::optional(known->second.fingerprint) : std::nullopt;
}

void FingerprintCache::keep(const std::string& path, const struct stat& status,
                            const std::string& fingerprint) {
  // A change within the same tick would not show.
  if (SystemClock::now() - changed_at(status) <= tick_of(status)) return;
  const std::lock_guard lock(mutex_);
  seen_[path] = {status_of(status), fingerprint, Clock::now()};
}

void FingerprintCache::read(Store& store, const std::filesystem::path& root) {
  const std::lock_guard lock(mutex_);
  former_ = store.get(name_of(root)).value_or("");
  std::istringstream lines(former_);
  Seen seen;
  for (std::string path; lines >> seen.status.device >> seen.status.inode >> seen.status.size >>
                             seen.status.changed >> seen.fingerprint &&
                         std::getline(lines.ignore(), path);) {
    seen_.emplace(std::move(path), seen);
  }
}

void FingerprintCache::write(Store& store, const std::filesystem::path& root) const {
  std::ostringstream lines;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [path, seen] : seen_) {
      const auto& [status, fingerprint, looked_at] = seen;
      if (!looked_at || path.find('\n') != path.npos) continue;
      lines << status.device << ' ' << status.inode << ' ' << status.size << ' ' << status.changed
            << ' ' << fingerprint << ' ' << path << '\n';
    }
  }
  if (lines.str() != former_) store.put(name_of(root), lines.str());
}

}  // namespace mjcourse
