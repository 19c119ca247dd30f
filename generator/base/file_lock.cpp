#include "base/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>

namespace mjcourse {

FileLock::FileLock(const std::filesystem::path& file, const LockWait& wait)
    : file_(open(file.c_str(), O_CREAT | O_RDWR | O_NOFOLLOW | O_CLOEXEC, 0644)) {
  if (!file_.is_open()) throw_errno(file);
  held_ = take_lock(file_.get(), LOCK_EX, file, wait);
}

}  // namespace mjcourse
