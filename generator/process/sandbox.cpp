#include "process/sandbox.h"

#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "process/landlock.h"
#include "process/syscall_filter.h"
#include "process/unprivileged_user.h"

namespace mjcourse {
namespace {

// systemd's list of user ids has these for nobody; a process id is at most 2^22.
constexpr uid_t kFirstOwnUser = 2'000'000'000;
constexpr uid_t kNobody = 65534;

// Tries each layer on itself, in the order of a real run; gives them as bits.
int try_layers(bool root, const SyscallFilter& plain, const SyscallFilter* watching) {
  int found = 0;
  if (root && become_user(kFirstOwnUser + static_cast<uid_t>(getpid()), false)) {
    found |= 1;
  } else if (root && become_user(kNobody, false)) {
    found |= 2;
  }
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return found;
  // The plain one lets no other come behind it.
  if (watching != nullptr && enter_filter_with_listener(*watching) >= 0) found |= 8;
  if (enter_filter(plain)) found |= 4;
  return found;
}

SandboxLevel find_level() {
  SandboxLevel level;
  level.landlock = landlock_abi();
  const SyscallFilter& plain = syscall_filter({.confine = true, .processes = true});
  const SyscallFilter* watching =
      can_watch() ? &syscall_filter({.watch = true, .asked = true}) : nullptr;
  const bool root = may_change_user();
  const pid_t child = fork();
  if (child == 0) _exit(try_layers(root, plain, watching));
  int status = 0;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (child < 0 || !WIFEXITED(status)) return level;
  const int found = WEXITSTATUS(status);
  if ((found & 1) != 0) level.user = SandboxLevel::User::own;
  if ((found & 2) != 0) level.user = SandboxLevel::User::nobody;
  level.filter = (found & 4) != 0;
  level.watch = level.filter && (found & 8) != 0;
  return level;
}

}  // namespace

std::optional<uid_t> SandboxLevel::user_for(pid_t pid) const {
  if (user == User::same) return std::nullopt;
  return user == User::nobody ? kNobody : kFirstOwnUser + static_cast<uid_t>(pid);
}

std::string SandboxLevel::text() const {
  std::string text = "rlimits, no_new_privs";
  if (filter) text += ", seccomp";
  if (watch) text += " with a watch on files";
  if (landlock > 0) text += ", Landlock " + std::to_string(landlock);
  if (user == User::own) text += ", a user id for each run";
  if (user == User::nobody) text += ", user id " + std::to_string(kNobody);
  return text;
}

std::string SandboxLevel::weakness() const {
  std::vector<std::string> weak;
  if (landlock == 0) weak.emplace_back("no Landlock keeps programs from files");
  if (!filter) weak.emplace_back("no seccomp keeps programs from system calls");
  if (landlock > 0 && landlock < kLandlockNetwork) {
    weak.emplace_back("seccomp alone keeps programs from the network");
  }
  if (landlock > 0 && landlock < kLandlockScopes) {
    weak.emplace_back("seccomp alone keeps signals from others");
  }
  if (!watch) weak.emplace_back("nobody sees which files a program names");
  if (user == User::same && geteuid() == 0) weak.emplace_back("programs run as root");
  std::string text;
  for (const std::string& one : weak) text += (text.empty() ? "" : "; ") + one;
  return text;
}

const SandboxLevel& sandbox_level() {
  static const SandboxLevel level = find_level();
  return level;
}

const std::vector<std::string>& readable_system_paths() {
  static const std::vector<std::string> paths{"/usr",
                                              "/lib",
                                              "/lib32",
                                              "/lib64",
                                              "/libx32",
                                              "/bin",
                                              "/sbin",
                                              "/opt",
                                              "/etc/alternatives",
                                              "/etc/ld.so.cache",
                                              "/etc/ld.so.preload",
                                              "/etc/localtime",
                                              "/dev/random",
                                              "/dev/urandom",
                                              "/dev/zero",
                                              "/proc/self",
                                              "/proc/cpuinfo",
                                              "/proc/meminfo",
                                              "/proc/stat",
                                              "/proc/filesystems",
                                              "/proc/sys/vm/overcommit_memory",
                                              "/sys/devices/system/cpu",
                                              "/sys/devices/system/node",
                                              "/sys/kernel/mm/transparent_hugepage"};
  return paths;
}

const std::vector<std::string>& writable_system_paths() {
  static const std::vector<std::string> paths{"/dev/null"};
  return paths;
}

bool is_within(std::string_view path, std::string_view folder) {
  return path.starts_with(folder) &&
         (path.size() == folder.size() || folder.ends_with('/') || path[folder.size()] == '/');
}

}  // namespace mjcourse
