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

Descriptor opened_or_made(int above, const std::string& name, const fs::path& path) {
  const auto opened = [&] { return Descriptor(openat(above, name.c_str(), kFolder | O_NOFOLLOW)); };
  Descriptor folder = opened();
  if (!folder.is_open() && errno == ENOENT) {
    if (mkdirat(above, name.c_str(), 0777) != 0 && errno != EEXIST) throw_errno(path);
    folder = opened();
  }
  if (folder.is_open()) return folder;
  const int reason = errno;
  if (is_link(above, name)) refuse(path, kIsLink);
  throw std::system_error(reason, std::generic_category(), path.string());
}

}  // namespace

struct OutFolder::Spot {
  Descriptor folder;
  std::string name;  // in it; "" where it is this folder itself
  fs::path path;     // of both together
};

OutFolder::OutFolder(fs::path folder)
    : path_(std::move(folder)), folder_(open(path_.c_str(), kFolder)) {
  if (!folder_.is_open()) throw_errno(path_);
}

OutFolder::Spot OutFolder::spot(const std::string& name) const {
  Spot spot{Descriptor(openat(folder_.get(), ".", kFolder)), "", path_};
  if (!spot.folder.is_open()) throw_errno(path_);
  if (name.starts_with('/')) refuse(name, "leads out of " + path_.string());
  for (const fs::path& part : fs::path(name)) {
    if (part.empty() || part == ".") continue;
    if (part == "..") refuse(path_ / name, "leads out of " + path_.string());
    if (!spot.name.empty()) spot.folder = opened_or_made(spot.folder.get(), spot.name, spot.path);
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
  const fs::path root = course.empty() ? fs::path() : fs::weakly_canonical(course);
  // The way from the course to what lies in it.
  const auto inside = [&](const fs::path& path) {
    return root.empty() ? "" : name_beneath(root, path).value_or("");
  };
  const fs::path whole = fs::absolute(named);
  std::deque<fs::path> rest(whole.begin(), whole.end());
  OutPath found;
  for (int links = 0; !rest.empty();) {
    const fs::path part = std::move(rest.front());
    rest.pop_front();
    if (part.empty() || part == ".") continue;
    const fs::path next = part == ".." ? found.path.parent_path() : found.path / part;
    std::error_code none;
    if (part == ".." || !fs::is_symlink(next, none)) {
      found.path = next;
      continue;
    }
    if (const std::string link = inside(next); !link.empty()) {
      return {next, link, link};
    }
    if (++links > kMostLinks) throw std::system_error(ELOOP, std::generic_category(), whole);
    const fs::path target = fs::read_symlink(next);
    if (target.is_absolute()) found.path.clear();
    rest.insert(rest.begin(), target.begin(), target.end());
  }
  found.inside = inside(found.path);
  return found;
}

OutPlace open_out_place(const fs::path& named, const fs::path& course) {
  const OutPath found = find_out_path(named, course);
  if (!found.link.empty()) refuse(found.link, kIsLink);
  if (found.inside.empty()) {
    fs::create_directories(found.path.parent_path());
    return {OutFolder(found.path.parent_path()), found.path.filename()};
  }
  const fs::path inside = found.inside;
  return {OutFolder(course).inner(inside.parent_path()), inside.filename()};
}

}  // namespace mjcourse
