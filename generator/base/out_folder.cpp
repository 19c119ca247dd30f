#include "base/out_folder.h"

#include <ext/stdio_filebuf.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <deque>
#include <ostream>
#include <system_error>

#include "base/beneath.h"
#include "base/checkout.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

constexpr const char* kIsLink = "is a link";
constexpr int kMostLinks = 40;  // as the kernel follows
constexpr int kFolder = O_PATH | O_DIRECTORY | O_CLOEXEC;
constexpr int kNewFile = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw RefusedPath(path.string() + " " + why + ", so nothing is written there");
}

bool is_link(int folder, const std::string& name) {
  struct stat status {};
  return fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 &&
         S_ISLNK(status.st_mode);
}

// Not open where there is nothing of the name.
Descriptor opened(int above, const std::string& name, const fs::path& path) {
  Descriptor folder(openat(above, name.c_str(), kFolder | O_NOFOLLOW));
  if (folder.is_open() || errno == ENOENT) return folder;
  const int reason = errno;
  if (is_link(above, name)) refuse(path, kIsLink);
  throw std::system_error(reason, std::generic_category(), path.string());
}

Descriptor opened_or_made(int above, const std::string& name, const fs::path& path) {
  Descriptor folder = opened(above, name, path);
  if (folder.is_open()) return folder;
  if (mkdirat(above, name.c_str(), 0777) != 0 && errno != EEXIST) throw_errno(path);
  folder = opened(above, name, path);
  if (!folder.is_open()) throw std::system_error(ENOENT, std::generic_category(), path.string());
  return folder;
}

// The way from `folder` to what lies in it; "" for any other path.
std::string name_in(const fs::path& folder, const fs::path& path) {
  return folder.empty() ? "" : name_beneath(folder, path).value_or("");
}

}  // namespace

struct OutFolder::Spot {
  Descriptor folder;  // not open where it is missing, and stays so
  std::string name;   // in it; "" where it is this folder itself
  fs::path path;      // of both together
};

OutFolder::OutFolder(fs::path folder)
    : path_(std::move(folder)), folder_(open(path_.c_str(), kFolder)) {
  if (!folder_.is_open()) throw_errno(path_);
}

OutFolder::Spot OutFolder::spot(const std::string& name, Missing missing) const {
  Spot spot{Descriptor(openat(folder_.get(), ".", kFolder)), "", path_};
  if (!spot.folder.is_open()) throw_errno(path_);
  if (name.starts_with('/')) refuse(name, "leads out of " + path_.string());
  for (const fs::path& part : fs::path(name)) {
    if (part.empty() || part == ".") continue;
    if (part == "..") refuse(path_ / name, "leads out of " + path_.string());
    if (!spot.name.empty()) {
      const auto enter = missing == Missing::is_made ? opened_or_made : opened;
      spot.folder = enter(spot.folder.get(), spot.name, spot.path);
      if (!spot.folder.is_open()) return spot;
    }
    spot.name = part;
    spot.path /= part;
  }
  return spot;
}

// Made anew, so that what is there is not written into: a link, or a file that has another name as
// well. Where two threads write one file, the later one's stays.
Descriptor OutFolder::created(const std::string& name) const {
  const Spot spot = this->spot(name);
  if (spot.name.empty()) throw std::system_error(EISDIR, std::generic_category(), path_.string());
  mode_t mode = 0666;
  while (true) {
    Descriptor file(openat(spot.folder.get(), spot.name.c_str(), kNewFile, mode));
    if (file.is_open()) return file;
    if (errno != EEXIST) throw_errno(spot.path);
    struct stat former {};
    if (fstatat(spot.folder.get(), spot.name.c_str(), &former, AT_SYMLINK_NOFOLLOW) == 0 &&
        S_ISREG(former.st_mode)) {
      mode &= former.st_mode;
    }
    if (unlinkat(spot.folder.get(), spot.name.c_str(), 0) != 0 && errno != ENOENT) {
      throw_errno(spot.path);
    }
  }
}

void OutFolder::write(const std::string& name, std::string_view bytes) const {
  const Descriptor file = created(name);
  write_all(file.get(), bytes, path_ / name);
}

void OutFolder::write(const std::string& name,
                      const std::function<void(std::ostream&)>& writer) const {
  Descriptor file = created(name);
  __gnu_cxx::stdio_filebuf<char> buffer(file.release(), std::ios::out | std::ios::binary);
  std::ostream stream(&buffer);
  errno = 0;
  writer(stream);
  const bool closed = buffer.close() != nullptr;
  if (closed && stream) return;
  throw std::system_error(errno ? errno : EIO, std::generic_category(), path_ / name);
}

bool OutFolder::holds_file(const std::string& name) const {
  const Spot spot = this->spot(name, Missing::stays);
  struct stat status {};
  if (!spot.folder.is_open() || spot.name.empty()) return false;
  if (fstatat(spot.folder.get(), spot.name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) {
    if (errno != ENOENT) throw_errno(spot.path);
    return false;
  }
  if (S_ISLNK(status.st_mode)) refuse(spot.path, kIsLink);
  return !S_ISDIR(status.st_mode);
}

OutFolder OutFolder::inner(const std::string& name) const {
  Spot spot = this->spot(name);
  if (!spot.name.empty()) spot.folder = opened_or_made(spot.folder.get(), spot.name, spot.path);
  return {std::move(spot.path), std::move(spot.folder)};
}

void OutFolder::move(const std::string& name, const OutFolder& other) const {
  const Spot from = spot(name), to = other.spot(name);
  if (renameat2(from.folder.get(), from.name.c_str(), to.folder.get(), to.name.c_str(),
                RENAME_NOREPLACE) != 0) {
    throw_errno(from.path);
  }
}

OutPath find_out_path(const fs::path& named, const fs::path& course) {
  const fs::path top = course.empty() ? fs::path() : fs::weakly_canonical(course);
  OutPath found;
  found.root = course.empty() ? top : checkout_of(top).value_or(top);
  const fs::path whole = fs::absolute(named);
  std::deque<fs::path> rest(whole.begin(), whole.end());
  for (int links = 0; !rest.empty() && !found.is_link;) {
    const fs::path part = std::move(rest.front());
    rest.pop_front();
    if (part.empty() || part == ".") continue;
    const fs::path next = part == ".." ? found.path.parent_path() : found.path / part;
    std::error_code none;
    if (part == ".." || !fs::is_symlink(next, none)) {
      found.path = next;
    } else if (!name_in(found.root, next).empty()) {
      found.path = next;
      found.is_link = true;
    } else {
      if (++links > kMostLinks) throw std::system_error(ELOOP, std::generic_category(), whole);
      const fs::path target = fs::read_symlink(next);
      if (target.is_absolute()) found.path.clear();
      rest.insert(rest.begin(), target.begin(), target.end());
    }
  }
  found.inside = name_in(found.root, found.path);
  found.shown = name_in(top, found.path);
  if (found.shown.empty()) found.shown = found.path.string();
  return found;
}

OutPlace open_out_place(const fs::path& named, const fs::path& course) {
  const OutPath found = find_out_path(named, course);
  if (found.is_link) refuse(found.shown, kIsLink);
  if (found.inside.empty()) {
    fs::create_directories(found.path.parent_path());
    return {OutFolder(found.path.parent_path()), found.path.filename()};
  }
  const fs::path inside = found.inside;
  return {OutFolder(found.root).inner(inside.parent_path()), inside.filename()};
}

}  // namespace mjcourse
