#include "base/attempt.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <fstream>
#include <new>
#include <system_error>

#include "base/descriptor.h"

namespace mjcourse {
namespace {

constexpr int kMemory = 1, kThrew = 2;  // exit codes

// Of address space, which a script engine reserves by the gigabyte.
std::uint64_t bytes_in_use() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

[[noreturn]] void work_within(const std::function<void()>& work, rlim_t bytes, rlim_t seconds) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal_number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
    signal(signal_number, SIG_DFL);
  }
  const rlimit none{0, 0}, memory{bytes, bytes}, time{seconds, seconds};
  setrlimit(RLIMIT_CORE, &none);
  setrlimit(RLIMIT_AS, &memory);
  setrlimit(RLIMIT_CPU, &time);
  // What a library has to say of it, it says again when it does it for good.
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  try {
    work();
  } catch (const std::bad_alloc&) {
    _exit(kMemory);
  } catch (...) {
    _exit(kThrew);
  }
  _exit(0);
}

// Its status, or nothing when it still worked at the end of its time.
int wait_for(pid_t child, double seconds, bool& in_time) {
  constexpr useconds_t pause = 500;
  int status = 0;
  pid_t ended = 0;
  for (double waited = 0; waited < seconds && ended == 0; waited += 1e-6 * pause) {
    ended = waitpid(child, &status, WNOHANG);
    if (ended == 0) usleep(pause);
  }
  in_time = ended == child;
  if (in_time) return status;
  kill(child, SIGKILL);
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

Attempt attempt(const std::function<void()>& work, std::uint64_t bytes, double seconds) {
  const rlim_t limit = bytes_in_use() + bytes;
  const pid_t child = fork();
  if (child < 0) throw_errno("fork");
  if (child == 0) work_within(work, limit, static_cast<rlim_t>(std::ceil(seconds)));
  bool in_time = false;
  const int status = wait_for(child, seconds, in_time);
  if (!in_time || (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)) return Attempt::too_long;
  if (WIFSIGNALED(status)) {
    return WTERMSIG(status) == SIGKILL ? Attempt::too_long : Attempt::crashed;
  }
  if (WEXITSTATUS(status) == kMemory) return Attempt::too_much_memory;
  return WEXITSTATUS(status) == 0 ? Attempt::done : Attempt::crashed;
}

}  // namespace mjcourse
