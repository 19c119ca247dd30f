#include "process/confinement.h"

#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/sysinfo.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <thread>

#include "process/unprivileged_user.h"

namespace mjcourse {
namespace {

constexpr rlim_t kStackBytes = 8 << 20;
constexpr unsigned kCloseOnExec = 1 << 2;  // CLOSE_RANGE_CLOEXEC

// Processes and threads are counted for the whole user. One that is used for nothing else has a
// count of its own; the other's has room for what runs already, the watcher counting exactly.
rlim_t most_tasks(const SandboxLevel& level) {
  struct sysinfo now {};
  if (level.user == SandboxLevel::User::own || sysinfo(&now) != 0) return rlim_t{2} * kMostThreads;
  return static_cast<rlim_t>(now.procs) + rlim_t{2} * kMostThreads;
}

// Of all threads together; the wall clock comes first, unless nobody is left to look at it.
rlim_t cpu_seconds(double seconds) {
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  return static_cast<rlim_t>(std::ceil(seconds) * cores) + 1;
}

}  // namespace

Confinement::Confinement(const Sandbox* sandbox, bool watch, double seconds)
    : confines_(sandbox != nullptr),
      asked_(sandbox != nullptr && sandbox_level().watch && (watch || sandbox->processes)) {
  if (sandbox == nullptr) return;
  level_ = sandbox_level();
  const rlim_t cpu = cpu_seconds(seconds), tasks = most_tasks(level_);
  const rlim_t space = sandbox->reserves ? RLIM_INFINITY : sandbox->memory_bytes;
  limits_ = {{RLIMIT_CPU, cpu, cpu + 1},
             {RLIMIT_AS, space, space},
             {RLIMIT_FSIZE, sandbox->file_bytes, sandbox->file_bytes},
             {RLIMIT_NPROC, tasks, tasks},
             {RLIMIT_NOFILE, sandbox->open_files, sandbox->open_files},
             {RLIMIT_STACK, kStackBytes, kStackBytes},
             {RLIMIT_MSGQUEUE, 0, 0},
             {RLIMIT_MEMLOCK, 0, 0},
             {RLIMIT_CORE, 0, 0}};
  using Access = LandlockRule::Access;
  const auto allow = [&](const std::vector<std::string>& paths, Access access) {
    for (const std::string& path : paths) rules_.push_back({path, access});
  };
  allow(readable_system_paths(), Access::read);
  allow(writable_system_paths(), Access::write);
  allow(sandbox->read, Access::read);
  allow(sandbox->write, Access::write);
  owned_ = sandbox->write;
  ports_ = sandbox->ports;
  reads_all_ = sandbox->reads_all && level_.landlock > 0;  // which says what is read
  if (level_.filter) {
    filter_ = &syscall_filter({.confine = true,
                               .processes = sandbox->processes,
                               .watch = asked_ && watch,
                               .asked = asked_,
                               .scoped = level_.landlock >= kLandlockScopes,
                               .network = sandbox->network,
                               .narrows = sandbox->narrows});
  }
}

bool Confinement::set_limits() const {
  for (const auto& [resource, soft, hard] : limits_) {
    rlimit now{};
    if (getrlimit(static_cast<__rlimit_resource>(resource), &now) != 0) return false;
    const rlimit lower{std::min(soft, now.rlim_max), std::min(hard, now.rlim_max)};
    if (setrlimit(static_cast<__rlimit_resource>(resource), &lower) != 0) return false;
  }
  return true;
}

bool Confinement::give_files(uid_t user) const {
  return std::all_of(owned_.begin(), owned_.end(), [&](const std::string& path) {
    return lchown(path.c_str(), user, user) == 0;
  });
}

int Confinement::enter(int& listener) const {
  listener = -1;
  // Whatever a library of ours left open stays behind; an old kernel has no such call.
  if (confines_) syscall(SYS_close_range, 3u, ~0u, kCloseOnExec);
  const int ruleset = level_.landlock > 0 ? make_ruleset(level_.landlock, rules_, ports_) : -1;
  if (level_.landlock > 0 && ruleset < 0) return errno;
  if (confines_) umask(022);
  if (const auto user = level_.user_for(getpid())) {
    if (!give_files(*user) || !become_user(*user, reads_all_)) return errno;
    // Becoming somebody else took it away.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
  }
  if (filter_ == nullptr && !confines_) return 0;
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return errno;
  if (ruleset >= 0 && !enter_ruleset(ruleset)) return errno;
  if (filter_ != nullptr && asked_) {
    listener = enter_filter_with_listener(*filter_);
    if (listener < 0) return errno;
  } else if (filter_ != nullptr && !enter_filter(*filter_)) {
    return errno;
  }
  // Last: the generator may have more files open, and more memory, than its programs may.
  return set_limits() ? 0 : errno;
}

}  // namespace mjcourse
