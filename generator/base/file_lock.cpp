#include "base/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "base/descriptor.h"

namespace mjcourse {

FileLock::FileLock(const std::filesystem::path& file, Patience patience)
    : descriptor_(open(file.c_str(), O_CREAT | O_RDWR | O_NOFOLLOW | O_CLOEXEC, 0644)) {
  if (descriptor_ < 0) throw_errno(file);
  const int operation = LOCK_EX | (patience == Patience::try_once ? LOCK_NB : 0);
  int result = 0;
  while ((result = flock(descriptor_, operation)) != 0 && errno == EINTR) {
  }
  held_ = result == 0;
}

FileLock::~FileLock() {
  close(descriptor_);
}

}  // namespace mjcourse
