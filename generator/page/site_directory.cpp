#include "page/site_directory.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/descriptor.h"
#include "base/files.h"

namespace mjcourse {
namespace fs = std::filesystem;
namespace {

constexpr const char* kMark = ".mjcourse-site";  // what tells a site of ours from other folders

fs::path beside(const fs::path& site, const std::string& suffix) {
  return site.parent_path() / ("." + site.filename().string() + suffix);
}

}  // namespace

SiteDirectory::SiteDirectory(const fs::path& site, fs::path course)
    : site_(fs::weakly_canonical(site)), course_(std::move(course)) {
  if (site_.filename().empty()) site_ = site_.parent_path();
  staging_ = beside(site_, ".building");
  if (!may_replace(site_)) {
    throw std::runtime_error(site_.string() +
                             " holds something that no build made; it would be "
                             "replaced. Name an empty or a new folder.");
  }
  fs::create_directories(site_.parent_path());
  const fs::path lock = beside(site_, ".lock");
  lock_ = open(lock.c_str(), O_CREAT | O_RDWR | O_NOFOLLOW | O_CLOEXEC, 0644);
  if (lock_ < 0) throw_errno(lock);
  if (flock(lock_, LOCK_EX | LOCK_NB) != 0) {
    close(lock_);
    throw std::runtime_error("another build is writing " + site_.string() + "; wait for it");
  }
  // Under the lock nobody else writes here: this is what a killed build left.
  fs::remove_all(staging_);
  // Made here, and no link that somebody put there.
  if (mkdir(staging_.c_str(), 0777) != 0) throw_errno(staging_);
  write_file(staging_ / kMark, "");
}

bool SiteDirectory::may_replace(const fs::path& site) {
  return !fs::exists(site) || fs::exists(site / kMark) ||
         (fs::is_directory(site) && fs::is_empty(site));
}

SiteDirectory::~SiteDirectory() {
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
  close(lock_);
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
  if (!file) throw std::system_error(errno ? errno : EIO, std::generic_category(), path);
}

bool SiteDirectory::is_new(const std::string& path) {
  const std::lock_guard guard(mutex_);
  return copied_.insert(path).second;
}

void SiteDirectory::copy(const fs::path& from, const std::string& path) {
  if (!is_new(path)) return;
  const auto bytes = read_beneath(course_, from);
  if (!bytes) throw std::runtime_error(bytes.error());
  write_file(staging_ / path, *bytes);
}

void SiteDirectory::copy_own(const fs::path& from, const std::string& path) {
  if (!is_new(path)) return;
  fs::create_directories((staging_ / path).parent_path());
  fs::copy(from, staging_ / path, fs::copy_options::recursive);
}

void SiteDirectory::commit() {
  if (!fs::exists(site_)) {
    fs::rename(staging_, site_);
  } else if (renameat2(AT_FDCWD, staging_.c_str(), AT_FDCWD, site_.c_str(), RENAME_EXCHANGE) != 0) {
    throw_errno(site_);
  }
  // The old site is now where the new one was made, and goes with this object.
}

}  // namespace mjcourse
