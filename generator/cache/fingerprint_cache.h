// FingerprintCache: keeps the fingerprints of files, which are believed for as long as the
// files' status stays the same.
//
// For one evaluation, or for several; and for the next run, where a store keeps them. A course
// depends on hundreds of the compiler's headers; one that was read once need not be read again.
// What counts is the status that nobody can set, the time of the last change to the file or its
// status, as in git's index.
#pragma once

#include <sys/stat.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "base/store.h"

namespace mjcourse {

// When the file, or what is known of it, was changed last, by the clock of its file system.
std::chrono::system_clock::time_point changed_at(const struct stat& status);

// Two changes may come so close that the file's time of change is the same.
std::chrono::system_clock::duration tick_of(const struct stat& status);

// The patience of a program that looks at a course again and again while it is being written: an
// upgrade of the compiler shows so much later.
inline constexpr std::chrono::seconds kPatienceWhileEditing{10};

class FingerprintCache {
 public:
  using Clock = std::chrono::steady_clock;

  // For so long, files outside of the course (the compiler's headers: some hundred for each
  // program) are believed to be as they were, and not even looked at.
  explicit FingerprintCache(Clock::duration patience = {}) : patience_(patience) {}

  // By absolute paths; all from any thread. Nothing where it is not known; of a file in this state;
  // of one that was looked at just now.
  std::optional<std::string> find(const std::string& path, const struct stat& status);
  std::optional<std::string> find_fresh(const std::string& path) const;
  void keep(const std::string& path, const struct stat& status, const std::string& fingerprint);

  // What `store` has of the course in `root`, and what it shall have: all that was looked at here.
  void read(Store& store, const std::filesystem::path& root);
  void write(Store& store, const std::filesystem::path& root) const;

 private:
  struct Status {
    std::uint64_t device, inode;
    std::int64_t size, changed;  // in nanoseconds
    bool operator==(const Status&) const = default;
  };
  static Status status_of(const struct stat& status);
  struct Seen {
    Status status;
    std::string fingerprint;
    std::optional<Clock::time_point> looked_at;  // here
  };
  Clock::duration patience_;
  mutable std::mutex mutex_;
  std::map<std::string, Seen> seen_;
  std::string former_;  // as the store had it
};

}  // namespace mjcourse
