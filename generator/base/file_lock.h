// FileLock: one process at a time, for as long as the object lives.
//
// The kernel gives the lock back when its holder dies, however that happens.
#pragma once

#include <filesystem>

namespace mjcourse {

class FileLock {
 public:
  enum class Patience { wait, try_once };

  // The file is made if it is not there, and stays. Throws std::system_error with the path where it
  // cannot be made, or is a link.
  explicit FileLock(const std::filesystem::path& file, Patience patience = Patience::wait);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  // False where somebody else holds it, after Patience::try_once.
  bool held() const { return held_; }

 private:
  int descriptor_ = -1;
  bool held_ = false;
};

}  // namespace mjcourse
