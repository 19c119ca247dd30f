// FileLock: one process at a time, for as long as the object lives.
//
// The kernel gives the lock back when its holder dies, however that happens.
#pragma once

#include <filesystem>

#include "base/descriptor.h"
#include "base/lock_wait.h"

namespace mjcourse {

class FileLock {
 public:
  // The file is made if it is not there, and stays. Throws std::system_error with the path where it
  // cannot be made, or is a link.
  explicit FileLock(const std::filesystem::path& file, const LockWait& wait = {});
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  // False where somebody else holds it, and the wait has ended.
  bool held() const { return held_; }

 private:
  Descriptor file_;
  bool held_ = false;
};

}  // namespace mjcourse
