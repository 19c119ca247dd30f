#include "base/replace_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <utility>

#include "base/beneath.h"
#include "base/files.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// A name that nobody else takes: another process has another number.
std::string name_beside(const std::string& name) {
  static std::atomic<unsigned> last{0};
  return "." + name + "." + std::to_string(getpid()) + "-" + std::to_string(++last);
}

// A file beside another that is gone again unless it took its place.
class Beside {
 public:
  // `called`: the other, in messages.
  Beside(Beneath::Spot spot, std::string called)
      : spot_(std::move(spot)), called_(std::move(called)), name_(name_beside(spot_.name)) {
    // What a killed process of the same number left.
    unlinkat(spot_.folder.get(), name_.c_str(), 0);
    file_ = openat(spot_.folder.get(), name_.c_str(),
                   O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
    if (file_ < 0) throw_errno(called_);
  }
  ~Beside() {
    close(file_);
    if (!name_.empty()) unlinkat(spot_.folder.get(), name_.c_str(), 0);
  }
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;

  // The owner and the mode of the file that it is to replace, or those of a new file.
  void take_mode() const {
    struct stat old {};
    if (fstatat(spot_.folder.get(), spot_.name.c_str(), &old, AT_SYMLINK_NOFOLLOW) == 0) {
      // Only root may give a file away; for others it is theirs already, or becomes so.
      if (fchown(file_, old.st_uid, old.st_gid) != 0 && errno != EPERM) throw_errno(called_);
      if (fchmod(file_, old.st_mode & 07777) != 0) throw_errno(called_);
      return;
    }
    const mode_t mask = umask(0);
    umask(mask);
    if (fchmod(file_, 0666 & ~mask) != 0) throw_errno(called_);
  }

  void write_all(std::string_view bytes) {
    mjcourse::write_all(file_, bytes, called_);
    if (fsync(file_) != 0) throw_errno(called_);
  }

  void take_its_place() {
    const int folder = spot_.folder.get();
    if (renameat(folder, name_.c_str(), folder, spot_.name.c_str()) != 0) throw_errno(called_);
    name_.clear();
    // The rename itself must reach the disk as well.
    const int opened = openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (opened < 0) return;
    fsync(opened);
    close(opened);
  }

 private:
  Beneath::Spot spot_;
  std::string called_, name_;
  int file_ = -1;
};

bool holds(const fs::path& folder, const std::string& name,
           const std::optional<std::string>& bytes) {
  const DiskFiles files(folder);
  if (!bytes) return !files.exists(name) && !files.is_folder(name);
  const auto now = files.read(name);
  return now && *now == *bytes;
}

}  // namespace

bool replace_file(const fs::path& folder, const std::string& name,
                  const std::optional<std::string>& before, std::string_view after) {
  fs::create_directories(folder);
  auto spot = Beneath(folder).spot(name, Beneath::Missing::is_made);
  if (!spot) throw_unopened(name, spot.error());
  Beside file(*std::move(spot), name);
  file.write_all(after);
  file.take_mode();
  if (!holds(folder, name, before)) return false;
  file.take_its_place();
  return true;
}

}  // namespace mjcourse
