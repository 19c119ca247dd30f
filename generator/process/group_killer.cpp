#include "process/group_killer.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>

namespace mjcourse {
namespace {

// More than there can be threads that wait for a program.
constexpr std::size_t kMostGroups = 1 << 14;

// Its own, which allocates nothing: the process that it is a copy of may have had other
// threads, one of which held the allocator's lock.
class Groups {
 public:
  void add(pid_t group) {
    if (count_ < groups_.size()) groups_[count_++] = group;
  }
  void remove(pid_t group) {
    auto* const end = groups_.data() + count_;
    auto* const found = std::find(groups_.data(), end, group);
    if (found == end) return;
    *found = *(end - 1);
    --count_;
  }
  void end_all() const {
    for (std::size_t i = 0; i < count_; ++i) kill(-groups_[i], SIGKILL);
  }

 private:
  std::array<pid_t, kMostGroups> groups_{};
  std::size_t count_ = 0;
};

// Moves it into a group of its own, blocks the signals that end the others, and closes all that is
// open. So a process that waits for the end of the generator's output does not wait for this one.
void stand_apart(int socket) {
  setsid();
  sigset_t all;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, nullptr);
  dup2(socket, STDIN_FILENO);
  constexpr unsigned last = ~0u;
  if (syscall(SYS_close_range, 1u, last, 0u) == 0) return;
  for (int number = 1; number < static_cast<int>(sysconf(_SC_OPEN_MAX)); ++number) close(number);
}

[[noreturn]] void watch_and_end(int socket) {
  static Groups groups;
  stand_apart(socket);
  // A number is a group that has begun; a negative one has ended.
  pid_t told = 0;
  for (ssize_t count = 0; (count = recv(STDIN_FILENO, &told, sizeof told, 0)) != 0;) {
    if (count < 0 && errno != EINTR) break;
    if (count == ssize_t{sizeof told} && told > 0) groups.add(told);
    if (count == ssize_t{sizeof told} && told < 0) groups.remove(-told);
  }
  groups.end_all();
  _exit(0);
}

}  // namespace

const GroupKiller& GroupKiller::instance() {
  static const GroupKiller killer;
  return killer;
}

GroupKiller::GroupKiller() {
  int ends[2];
  // Its end is the end of the last process that has ours, and no program inherits that.
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) return;
  const pid_t child = fork();
  if (child == 0) watch_and_end(ends[1]);
  close(ends[1]);
  if (child < 0) {
    close(ends[0]);
  } else {
    socket_ = ends[0];
  }
}

void GroupKiller::watch(pid_t group) const {
  tell(group);
}

void GroupKiller::forget(pid_t group) const {
  tell(-group);
}

void GroupKiller::tell(pid_t group) const {
  if (socket_ < 0) return;
  while (send(socket_, &group, sizeof group, MSG_NOSIGNAL) < 0 && errno == EINTR) {
  }
}

}  // namespace mjcourse
