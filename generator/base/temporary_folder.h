// A folder for one piece of work, gone with everything in it when the work is done.
//
// A process that is killed cannot clear up. So each folder is locked for as long as its owner
// lives, and the next process to make one first removes those that nobody holds a lock on.
#pragma once

#include <filesystem>

namespace mjcourse {

class TemporaryFolder {
 public:
  // Throws std::system_error when the system's folder for temporary files takes no more.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int lock_ = -1;
};

}  // namespace mjcourse
