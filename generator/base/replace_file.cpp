#include "base/replace_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <system_error>

#include "base/descriptor.h"
#include "base/files.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// What a chain of links ends at, whether it is there or not.
fs::path target_of(fs::path path) {
  constexpr int most_links = 40;  // as the kernel follows
  for (int i = 0; fs::is_symlink(path); ++i) {
    if (i == most_links) {
      errno = ELOOP;
      throw_errno(path);
    }
    path = path.parent_path() / fs::read_symlink(path);
  }
  return path;
}

// A file beside `path` that is gone again unless it took its place.
class Beside {
 public:
  explicit Beside(const fs::path& path)
      : path_(path),
        name_((path.parent_path() / ("." + path.filename().string() + ".XXXXXX")).string()),
        file_(mkostemp(name_.data(), O_CLOEXEC)) {
    if (file_ < 0) throw_errno(path_);
  }
  ~Beside() {
    if (file_ >= 0) close(file_);
    if (!name_.empty()) unlink(name_.c_str());
  }
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;

  // The owner and the mode of the file that it is to replace, or those of a new file.
  void take_mode() const {
    struct stat old {};
    if (stat(path_.c_str(), &old) == 0) {
      // Only root may give a file away; for others it is theirs already, or becomes so.
      if (fchown(file_, old.st_uid, old.st_gid) != 0 && errno != EPERM) throw_errno(path_);
      if (fchmod(file_, old.st_mode & 07777) != 0) throw_errno(path_);
      return;
    }
    const mode_t mask = umask(0);
    umask(mask);
    if (fchmod(file_, 0666 & ~mask) != 0) throw_errno(path_);
  }

  void write_all(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t written = write(file_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) throw_errno(path_);
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    if (fsync(file_) != 0) throw_errno(path_);
  }

  void take_its_place() {
    if (rename(name_.c_str(), path_.c_str()) != 0) throw_errno(path_);
    name_.clear();
    // The rename itself must reach the disk as well.
    const int folder = open(path_.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) return;
    fsync(folder);
    close(folder);
  }

 private:
  fs::path path_;
  std::string name_;
  int file_;
};

bool holds(const fs::path& path, const std::optional<std::string>& bytes) {
  if (!bytes) return !fs::exists(path);
  const auto now = DiskFiles(path.parent_path()).read(path.filename().string());
  return now && *now == *bytes;
}

}  // namespace

bool replace_file(const fs::path& path, const std::optional<std::string>& before,
                  std::string_view after) {
  const fs::path target = target_of(fs::absolute(path));
  fs::create_directories(target.parent_path());
  Beside file(target);
  file.write_all(after);
  file.take_mode();
  if (!holds(target, before)) return false;
  file.take_its_place();
  return true;
}

}  // namespace mjcourse
