#include "page/site_directory.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/files.h"
#include "base/utf8.h"
#include "page/foreign_files.h"

namespace mjcourse {
namespace fs = std::filesystem;
namespace {

// The site's list has a line for each file, and no address contains control characters.
const std::string& checked(const std::string& path) {
  if (readable(path) == path) return path;
  throw std::runtime_error("no file of a site is called " + readable(path));
}

constexpr int kLock = O_CREAT | O_RDWR | O_NOFOLLOW | O_CLOEXEC;

}  // namespace

void SiteDirectory::refuse_others(const fs::path& site) {
  if (!fs::exists(site) || has_site_list(site)) return;
  if (fs::exists(site / kSiteList)) {
    throw FolderRefused(
        site.string() + " was written by an earlier mjcourse, which kept no list of its files",
        "take what is yours out of it and remove it, or name an empty or a new "
        "folder");
  }
  if (fs::is_directory(site) && fs::is_empty(site)) return;
  throw FolderRefused(site.string() + " holds something that no build made, and would be replaced",
                      "name an empty or a new folder");
}

SiteDirectory::SiteDirectory(const fs::path& site, fs::path course)
    : place_(open_out_place(site, course)),
      site_(place_.path()),
      course_(std::move(course)),
      making_("." + place_.name + ".building") {
  refuse_others(site_);
  const OutFolder& above = place_.folder;
  const std::string name = "." + place_.name + ".lock";
  const fs::path lock = above.path() / name, staging = above.path() / making_;
  lock_ = Descriptor(openat(above.descriptor(), name.c_str(), kLock, 0644));
  if (!lock_.is_open() && errno == ELOOP) {
    throw FolderRefused(lock.string() + " is a link", "remove it; builds keep others out by it");
  }
  if (!lock_.is_open()) throw_errno(lock);
  if (flock(lock_.get(), LOCK_EX | LOCK_NB) != 0) {
    throw std::runtime_error("another build is writing " + site_.string() + "; wait for it");
  }
  // Under the lock nobody else writes here: this is what a killed build left, perhaps behind its
  // exchange.
  if (has_site_list(staging)) put_back_foreign_files();
  fs::remove_all(staging);
  // Made here, and no link that somebody put there.
  if (mkdirat(above.descriptor(), making_.c_str(), 0777) != 0) throw_errno(staging);
  staging_ = above.inner(making_);
}

SiteDirectory::~SiteDirectory() {
  std::error_code ignored;
  if (!holds_foreign_files_) fs::remove_all(place_.folder.path() / making_, ignored);
}

void SiteDirectory::write(const std::string& path, std::string_view bytes) {
  staging_->write(checked(path), bytes);
}

void SiteDirectory::write(const std::string& path,
                          const std::function<void(std::ostream&)>& writer) {
  staging_->write(checked(path), writer);
}

bool SiteDirectory::is_new(const std::string& path) {
  const std::lock_guard guard(mutex_);
  return copied_.insert(path).second;
}

void SiteDirectory::copy(const fs::path& from, const std::string& path) {
  if (!is_new(path)) return;
  const auto bytes = read_beneath(course_, from);
  if (!bytes) throw LostFile(bytes.error());
  write(path, *bytes);
}

void SiteDirectory::copy_own(const fs::path& from, const std::string& path) {
  if (!is_new(path)) return;
  if (fs::is_directory(from)) {
    for (const fs::directory_entry& entry : fs::directory_iterator(from)) {
      copy_own(entry.path(), path + "/" + entry.path().filename().string());
    }
    return;
  }
  // By reading and writing, which tell of a full disk: fs::copy() calls that an "Input/output
  // error".
  const auto bytes = read_file(from);
  if (!bytes) throw std::runtime_error(bytes.error());
  write(path, *bytes);
}

// What is foreign in the old site, which lies where the new one was made, belongs to that.
void SiteDirectory::put_back_foreign_files() {
  move_foreign_files(place_.folder.inner(making_), place_.folder.inner(place_.name));
}

void SiteDirectory::put_into_place(unsigned flags) {
  const int above = place_.folder.descriptor();
  if (renameat2(above, making_.c_str(), above, place_.name.c_str(), flags) != 0) {
    throw_errno(site_);
  }
}

void SiteDirectory::commit() {
  write_site_list(*staging_);
  if (!fs::exists(site_)) {
    put_into_place(0);
    return;
  }
  foreign_files(site_, staging_->path());  // is none of them in the way?
  put_into_place(RENAME_EXCHANGE);
  // The old site is now where the new one was made, and goes with this object, but for what is
  // foreign in it.
  holds_foreign_files_ = true;
  try {
    put_back_foreign_files();
  } catch (...) {
    put_into_place(RENAME_EXCHANGE);
    holds_foreign_files_ = false;
    throw;
  }
  holds_foreign_files_ = false;
}

}  // namespace mjcourse
