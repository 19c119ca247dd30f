#include "base/temporary_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <mutex>
#include <string>
#include <system_error>

#include "base/descriptor.h"
#include "base/remove_folder.h"

namespace mjcourse {
namespace fs = std::filesystem;
namespace {

const std::string kPrefix = "mjcourse-work-";
// Its files can be used by any program that was told of them, such as a program that is no longer
// root.
constexpr mode_t kMode = 0711;

// A descriptor that holds the lock on `folder`; -1 where somebody else does.
int try_lock(const fs::path& folder) {
  constexpr int flags = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;
  int descriptor = open(folder.c_str(), flags);
  if (descriptor < 0 && errno == EACCES &&
      fchmodat(AT_FDCWD, folder.c_str(), kMode, AT_SYMLINK_NOFOLLOW) == 0) {
    descriptor = open(folder.c_str(), flags);  // one of our programs had closed it
  }
  if (descriptor >= 0 && flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  if (descriptor >= 0) close(descriptor);
  return -1;
}

void remove_abandoned(const fs::path& parent) {
  std::error_code ignored;  // a folder of somebody else's is not ours to remove
  for (const fs::directory_entry& entry : fs::directory_iterator(parent, ignored)) {
    if (!entry.path().filename().string().starts_with(kPrefix)) continue;
    const int lock = try_lock(entry.path());
    if (lock < 0) continue;
    remove_folder(entry.path());
    close(lock);
  }
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  // Without links: programs tell their folder, and files in it, by their true names.
  const fs::path parent = fs::canonical(fs::temp_directory_path());
  static std::once_flag swept;
  std::call_once(swept, remove_abandoned, parent);
  // Another process may take a folder that is not locked yet for an abandoned one.
  while (lock_ < 0 || !fs::exists(path_)) {
    if (lock_ >= 0) close(lock_);
    std::string name = (parent / (kPrefix + "XXXXXX")).string();
    if (mkdtemp(name.data()) == nullptr) {
      throw_errno(name);
    }
    path_ = name;
    chmod(name.c_str(), kMode);
    lock_ = try_lock(path_);
  }
}

TemporaryFolder::~TemporaryFolder() {
  remove_folder(path_);  // nothing to be done about a failure here, and nothing is lost
  close(lock_);
}

}  // namespace mjcourse
