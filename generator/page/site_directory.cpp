#include "page/site_directory.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/files.h"
#include "page/foreign_files.h"

namespace mjcourse {
namespace fs = std::filesystem;
namespace {

fs::path beside(const fs::path& site, const std::string& suffix) {
  return site.parent_path() / ("." + site.filename().string() + suffix);
}

void exchange(const fs::path& one, const fs::path& other) {
  if (renameat2(AT_FDCWD, one.c_str(), AT_FDCWD, other.c_str(), RENAME_EXCHANGE) != 0) {
    throw_errno(other);
  }
}

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
    : site_(fs::weakly_canonical(site)), course_(std::move(course)) {
  if (site_.filename().empty()) site_ = site_.parent_path();
  staging_ = beside(site_, ".building");
  refuse_others(site_);
  fs::create_directories(site_.parent_path());
  const fs::path lock = beside(site_, ".lock");
  lock_ = Descriptor(open(lock.c_str(), O_CREAT | O_RDWR | O_NOFOLLOW | O_CLOEXEC, 0644));
  if (!lock_.is_open() && errno == ELOOP) {
    throw FolderRefused(lock.string() + " is a link", "remove it; builds keep others out by it");
  }
  if (!lock_.is_open()) throw_errno(lock);
  if (flock(lock_.get(), LOCK_EX | LOCK_NB) != 0) {
    throw std::runtime_error("another build is writing " + site_.string() + "; wait for it");
  }
  // Under the lock nobody else writes here: this is what a killed build left.
  put_back_foreign_files();
  fs::remove_all(staging_);
  // Made here, and no link that somebody put there.
  if (mkdir(staging_.c_str(), 0777) != 0) throw_errno(staging_);
}

SiteDirectory::~SiteDirectory() {
  std::error_code ignored;
  if (!holds_foreign_files_) fs::remove_all(staging_, ignored);
}

void SiteDirectory::write(const std::string& path, std::string_view bytes) {
  write_file(staging_ / path, bytes);
}

void SiteDirectory::write(const std::string& path,
                          const std::function<void(std::ostream&)>& writer) {
  fs::create_directories((staging_ / path).parent_path());
  errno = 0;
  std::ofstream file(staging_ / path, std::ios::binary | std::ios::trunc);
  writer(file);
  file.close();
  if (!file) throw std::system_error(errno ? errno : EIO, std::generic_category(), staging_ / path);
}

bool SiteDirectory::is_new(const std::string& path) {
  const std::lock_guard guard(mutex_);
  return copied_.insert(path).second;
}

void SiteDirectory::copy(const fs::path& from, const std::string& path) {
  if (!is_new(path)) return;
  const auto bytes = read_beneath(course_, from);
  if (!bytes) throw LostFile(bytes.error());
  write_file(staging_ / path, *bytes);
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
  write_file(staging_ / path, *bytes);
}

// A build was killed behind its exchange: what is foreign in the old site belongs to the new one.
void SiteDirectory::put_back_foreign_files() {
  if (!has_site_list(staging_)) return;
  fs::create_directories(site_);
  move_foreign_files(staging_, site_);
}

void SiteDirectory::commit() {
  write_site_list(staging_);
  if (!fs::exists(site_)) {
    fs::rename(staging_, site_);
    return;
  }
  foreign_files(site_, staging_);  // is none of them in the way?
  exchange(staging_, site_);
  // The old site is now where the new one was made, and goes with this object, but for what is
  // foreign in it.
  holds_foreign_files_ = true;
  try {
    move_foreign_files(staging_, site_);
  } catch (...) {
    exchange(staging_, site_);
    holds_foreign_files_ = false;
    throw;
  }
  holds_foreign_files_ = false;
}

}  // namespace mjcourse
