#include "base/remove_folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>
#include <vector>

#include "base/descriptor.h"
#include "base/folder_names.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

class Removal {
 public:
  std::error_code remove(int above, const std::string& top) {
    if (is_done(unlinkat(above, top.c_str(), 0))) return failure_;  // a file, a link, or nothing
    if (errno != EISDIR) note_failure();
    if (failure_) return failure_;
    top_ = opened(above, top);
    if (!top_.is_open()) return failure_;
    for (const std::string& name : names_in_folder(top_.get())) {
      remove_or_keep(top_.get(), name, name);
    }
    while (!kept_.empty()) {
      const std::string name = std::move(kept_.back());
      kept_.pop_back();
      empty(name);
      if (unlinkat(top_.get(), name.c_str(), AT_REMOVEDIR) != 0) note_failure();
    }
    if (unlinkat(above, top.c_str(), AT_REMOVEDIR) != 0) note_failure();
    return failure_;
  }

 private:
  void note_failure() {
    if (!failure_) failure_ = std::error_code(errno, std::generic_category());
  }

  static bool is_done(int result) { return result == 0 || errno == ENOENT; }

  // The folder, which we may list, and change, from now on.
  Descriptor opened(int above, const std::string& name) {
    fchmodat(above, name.c_str(), S_IRWXU, AT_SYMLINK_NOFOLLOW);
    Descriptor folder(openat(above, name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    if (!folder.is_open()) note_failure();
    return folder;
  }

  // Files of the folder `name` at the top go; its folders come to lie beside it.
  void empty(const std::string& name) {
    const Descriptor folder = opened(top_.get(), name);
    if (!folder.is_open()) return;
    for (const std::string& inner : names_in_folder(folder.get())) {
      remove_or_keep(folder.get(), inner, "");
    }
  }

  // `kept_as`: its name where it lies at the top already; a new one for "".
  void remove_or_keep(int folder, const std::string& name, const std::string& kept_as) {
    if (is_done(unlinkat(folder, name.c_str(), 0))) return;
    if (errno != EISDIR) return note_failure();
    if (is_done(unlinkat(folder, name.c_str(), AT_REMOVEDIR))) return;
    if (!kept_as.empty()) return kept_.push_back(kept_as);
    // To be moved, it has to be ours to write.
    fchmodat(folder, name.c_str(), S_IRWXU, AT_SYMLINK_NOFOLLOW);
    std::string there;
    int moved = 0;
    do {
      there = std::to_string(++last_);
      moved = renameat2(folder, name.c_str(), top_.get(), there.c_str(), RENAME_NOREPLACE);
    } while (moved != 0 && errno == EEXIST);
    if (moved != 0) return note_failure();
    kept_.push_back(std::move(there));
  }

  Descriptor top_;
  std::vector<std::string> kept_;  // folders at the top that are not removed yet
  std::size_t last_ = 0;           // of the names that were given there
  std::error_code failure_;
};

}  // namespace

std::error_code remove_folder(const fs::path& folder) {
  return remove_folder(AT_FDCWD, folder.string());
}

std::error_code remove_folder(int above, const std::string& name) {
  return Removal().remove(above, name);
}

}  // namespace mjcourse
