#include "process/attempt.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/time.h>
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
// Address space costs nothing until it is used, and some ask for more than they ever touch.
constexpr rlim_t kSpaceToMemory = 4;
constexpr suseconds_t kLook = 1000;  // microseconds, in which some megabytes can be touched

std::uint64_t most_resident = 0;  // in the child

// The most that it ever had, which no allocator can hide.
std::uint64_t peak_resident() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  return static_cast<std::uint64_t>(use.ru_maxrss) << 10;
}

extern "C" void look_at_memory(int /*signal*/) {
  if (peak_resident() > most_resident) _exit(kMemory);
}

// Memory that was there at the fork does not count. A signal comes between any two instructions, so
// the process ends wherever it takes too much.
void watch_memory(std::uint64_t bytes) {
  most_resident = peak_resident() + bytes;
  struct sigaction look {};
  look.sa_handler = look_at_memory;
  look.sa_flags = SA_RESTART;
  sigaction(SIGALRM, &look, nullptr);
  const itimerval often{{0, kLook}, {0, kLook}};
  setitimer(ITIMER_REAL, &often, nullptr);
}

// Of address space, which a script engine reserves by the gigabyte.
std::uint64_t bytes_in_use() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

[[noreturn]] void work_within(const std::function<void()>& work, std::uint64_t bytes, rlim_t space,
                              rlim_t seconds) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal_number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
    signal(signal_number, SIG_DFL);
  }
  const rlimit none{0, 0}, memory{space, space}, time{seconds, seconds};
  setrlimit(RLIMIT_CORE, &none);
  setrlimit(RLIMIT_AS, &memory);
  setrlimit(RLIMIT_CPU, &time);
  // What a library has to say of it, it says again when it does it for good.
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  watch_memory(bytes);
  try {
    work();
  } catch (const std::bad_alloc&) {
    _exit(kMemory);
  } catch (...) {
    _exit(kThrew);
  }
  look_at_memory(0);
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
  const rlim_t space = bytes_in_use() + kSpaceToMemory * bytes;
  const pid_t child = fork();
  if (child < 0) throw_errno("fork");
  if (child == 0) work_within(work, bytes, space, static_cast<rlim_t>(std::ceil(seconds)));
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
