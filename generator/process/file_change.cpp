#include "process/file_change.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <span>

#include "base/descriptor.h"
#include "process/process_memory.h"
#include "process/sandbox.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kSettableMode = S_ISVTX | S_IRWXU | S_IRWXG | S_IRWXO;

// A file as a system call names it.
struct NamedFile {
  int folder = AT_FDCWD;
  std::uint64_t path = 0;  // where its name is; 0 for `folder` itself
  int flags = 0;
};

// In a path of the program's, `self` is the program.
std::string seen_from_here(std::string path, const std::string& process) {
  for (const std::string self : {"/proc/self/", "/proc/thread-self/"}) {
    if (path.starts_with(self)) return process + path.substr(self.size() - 1);
  }
  return path;
}

// A descriptor that only names the file; a closed one where errno says why.
Descriptor open_named(pid_t asker, const NamedFile& file) {
  const std::string process = "/proc/" + std::to_string(asker);
  const std::string folder =
      process + (file.folder == AT_FDCWD ? "/cwd" : "/fd/" + std::to_string(file.folder));
  std::string path;
  if (file.path != 0) {
    const auto text = read_text(asker, file.path);
    if (!text) {
      errno = EFAULT;
      return Descriptor();
    }
    path = seen_from_here(*text, process);
  }
  if (file.path != 0 && path.empty() && (file.flags & AT_EMPTY_PATH) == 0) {
    errno = ENOENT;
    return Descriptor();
  }
  const int flags = O_PATH | O_CLOEXEC | ((file.flags & AT_SYMLINK_NOFOLLOW) != 0 ? O_NOFOLLOW : 0);
  if (path.starts_with('/')) return Descriptor(open(path.c_str(), flags));
  Descriptor base(open(folder.c_str(), O_PATH | O_CLOEXEC));
  if (!base.is_open() || path.empty()) return base;
  return Descriptor(openat(base.get(), path.c_str(), flags));
}

std::string own_link(const Descriptor& file) {
  return "/proc/self/fd/" + std::to_string(file.get());
}

bool lies_in(const Descriptor& file, const std::vector<std::string>& own) {
  std::error_code error;
  const std::string path = fs::read_symlink(own_link(file), error).string();
  return !error && std::any_of(own.begin(), own.end(),
                               [&](const std::string& one) { return is_within(path, one); });
}

int error_of(int result) {
  return result == 0 ? 0 : errno;
}

// To the two times at `address`; for 0, to now.
int set_times(const Descriptor& file, pid_t asker, std::uint64_t address) {
  std::array<timespec, 2> times{{{0, UTIME_NOW}, {0, UTIME_NOW}}};
  const std::span<char> bytes(reinterpret_cast<char*>(times.data()), sizeof times);
  if (address != 0 && !read_memory(asker, address, bytes)) return EFAULT;
  return error_of(utimensat(AT_FDCWD, own_link(file).c_str(), times.data(), 0));
}

int set_mode(const Descriptor& file, std::uint64_t mode) {
  return error_of(chmod(own_link(file).c_str(), static_cast<mode_t>(mode) & kSettableMode));
}

NamedFile file_of(const seccomp_data& call) {
  const auto number = [&](int argument) { return static_cast<int>(call.args[argument]); };
  if (call.nr == SCMP_SYS(chmod) || call.nr == SCMP_SYS(truncate))
    return {AT_FDCWD, call.args[0], 0};
  if (call.nr == SCMP_SYS(fchmod)) return {number(0), 0, 0};
  if (call.nr == SCMP_SYS(fchmodat)) return {number(0), call.args[1], 0};
  return {number(0), call.args[1], number(3)};
}

}  // namespace

bool is_file_change(int call) {
  return call == SCMP_SYS(chmod) || call == SCMP_SYS(fchmod) || call == SCMP_SYS(fchmodat) ||
         call == SCMP_SYS(utimensat) || call == SCMP_SYS(truncate);
}

int change_file(const seccomp_notif& question, const OwnFiles& files) {
  const auto asker = static_cast<pid_t>(question.pid);
  const seccomp_data& call = question.data;
  const Descriptor file = open_named(asker, file_of(call));
  if (!file.is_open()) return errno;
  if (!lies_in(file, files.own)) return EPERM;
  if (call.nr == SCMP_SYS(utimensat)) return set_times(file, asker, call.args[2]);
  if (call.nr == SCMP_SYS(truncate)) {
    // The limit of the program's own is not ours.
    if (call.args[1] > files.bytes) return EFBIG;
    return error_of(truncate(own_link(file).c_str(), static_cast<off_t>(call.args[1])));
  }
  return set_mode(file, call.nr == SCMP_SYS(fchmodat) ? call.args[2] : call.args[1]);
}

}  // namespace mjcourse
