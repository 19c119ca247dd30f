#include "process/child_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>
#include <utility>

#include "base/descriptor.h"
#include "process/group_killer.h"
#include "process/launch.h"

namespace mjcourse {
namespace {

// Both are close-on-exec: a child started by another thread must not hold them open.
struct Pair {
  Descriptor read, write;
};

Pair make_pipe() {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw_errno("pipe");
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

Pair make_sockets(int type) {
  int ends[2];
  if (socketpair(AF_UNIX, type | SOCK_CLOEXEC, 0, ends) != 0) {
    throw_errno("socketpair");
  }
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

}  // namespace

ChildProcess::ChildProcess(const Command& command) {
  Pair outs = make_pipe(), errs = make_pipe(), sockets = make_sockets(SOCK_SEQPACKET);
  const bool talks = command.answers || command.hears;
  Pair ins = talks ? make_sockets(SOCK_STREAM) : Pair{Descriptor(), Descriptor()};
  Launch launch(command, {std::move(ins.read), std::move(outs.write), std::move(errs.write),
                          std::move(sockets.write)});
  // What loses its parent becomes our child, so that it can be waited for.
  static const int adopts = prctl(PR_SET_CHILD_SUBREAPER, 1);
  static_cast<void>(adopts);
  parent_ = std::jthread([this, launch = std::move(launch)]() mutable {
    if (launch.go()) gone_.acquire();  // with this thread, the program would end
  });
  const LaunchNews first = read_launch_news(sockets.read.get());
  if (first.id < 0) throw std::system_error(first.failure, std::generic_category(), "vfork");
  id_ = first.id;
  ended = Descriptor(static_cast<int>(syscall(SYS_pidfd_open, id_, 0)));
  in = std::move(ins.write);
  out = std::move(outs.read);
  err = std::move(errs.read);
  news = std::move(sockets.read);
}

ChildProcess::~ChildProcess() {
  end();
}

bool ChildProcess::has_ended() const {
  siginfo_t information{};
  // It stays to be waited for, so that nobody else gets its number, which is also its group's.
  return waitid(P_PID, static_cast<id_t>(id_), &information, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         information.si_pid == id_;
}

int ChildProcess::end() {
  if (id_ < 0) return status_;
  kill(-id_, SIGKILL);  // whatever the program left behind goes with it
  for (pid_t ended_one = 0; ended_one >= 0 || errno == EINTR;) {
    int status = 0;
    ended_one = waitpid(-id_, &status, __WALL);
    if (ended_one == id_) status_ = status;
  }
  GroupKiller::instance().forget(id_);
  id_ = -1;
  gone_.release();
  return status_;
}

}  // namespace mjcourse
