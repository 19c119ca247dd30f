// Waiting for a lock of flock(2), with a word and an end.
//
// Each process that can open a file can lock it, and may never let it go; so nothing waits for a
// lock without saying so, and what can go on without it does.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace mjcourse {

struct LockWait {
  std::optional<std::chrono::milliseconds> most = std::nullopt;  // nothing: for ever
  std::chrono::milliseconds quiet = std::chrono::seconds(2);     // before it is told
  // Gets a sentence for the user, once.
  std::function<void(const std::string&)> tell = nullptr;

  // Not at all.
  static LockWait none() { return {.most = std::chrono::milliseconds(0)}; }
};

// Locks the open file as flock(2) does for `operation`; `path` is for messages. False where it was
// not to be had in time. Throws std::system_error where it cannot be locked at all.
bool take_lock(int file, int operation, const std::filesystem::path& path, const LockWait& wait);

// "process 17 (name)" that holds a lock on the open file, where the kernel says so, or "another
// process".
std::string lock_holder(int file);

}  // namespace mjcourse
