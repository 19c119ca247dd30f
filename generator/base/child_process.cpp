#include "base/child_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/confinement.h"

namespace mjcourse {
namespace {

// Both are close-on-exec: a child started by another thread must not hold them open.
struct Ends {
  Descriptor read, write;
};

Ends make_pipe() {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

Ends make_sockets() {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) {
    throw std::system_error(errno, std::generic_category(), "socketpair");
  }
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

// Whether the command sets the variable of "NAME=value" itself. Of two with one name, getenv finds
// the first and a shell keeps the last.
bool sets(const Command& command, std::string_view variable) {
  const std::string_view name = variable.substr(0, variable.find('='));
  return std::any_of(command.environment.begin(), command.environment.end(),
                     [&](std::string_view own) { return own.substr(0, own.find('=')) == name; });
}

// What execvpe needs, made before fork: after it only async-signal-safe calls are allowed.
struct Vectors {
  std::vector<char*> arguments, environment;
  std::vector<std::string> fixed;
  explicit Vectors(const Command& command) {
    if (command.sandbox) {
      fixed = {"HOME=" + command.folder, "TMPDIR=" + command.folder, "LC_ALL=C.UTF-8",
               "PATH=/usr/local/bin:/usr/bin:/bin"};
    }
    for (const std::string& a : command.arguments)
      arguments.push_back(const_cast<char*>(a.c_str()));
    for (const std::string& e : command.environment) {
      environment.push_back(const_cast<char*>(e.c_str()));
    }
    for (const std::string& f : fixed) {
      if (!sets(command, f)) environment.push_back(const_cast<char*>(f.c_str()));
    }
    for (char** e = environ; *e != nullptr; ++e) {
      // Of our own, a program in a sandbox gets nothing: no secrets, and no one's settings.
      if (!command.sandbox && !sets(command, *e)) environment.push_back(*e);
    }
    arguments.push_back(nullptr);
    environment.push_back(nullptr);
  }
};

// One message: an errno, and with it a descriptor where there is one.
void tell(int news, int failure, int listener) {
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
  iovec part{&failure, sizeof failure};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  if (listener >= 0) {
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    cmsghdr* header = CMSG_FIRSTHDR(&message);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(sizeof(int));
    std::memcpy(CMSG_DATA(header), &listener, sizeof listener);
  }
  sendmsg(news, &message, MSG_NOSIGNAL);
}

[[noreturn]] void become(const Command& command, const Vectors& vectors,
                         const Confinement& confinement, pid_t parent, int out, int err, int news) {
  setpgid(0, 0);
  // A generator that is killed takes its programs along; one that never ends would go on for ever.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  // The script engine installs handlers and the launcher may ignore signals: start clean.
  for (const int number : {SIGPIPE, SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGCHLD, SIGUSR1})
    signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  if (command.folder.empty() || chdir(command.folder.c_str()) == 0) {
    int listener = -1;
    errno = confinement.enter(listener);
    if (errno == 0) {
      if (listener >= 0) tell(news, 0, listener);
      execvpe(vectors.arguments[0], vectors.arguments.data(), vectors.environment.data());
    }
  }
  tell(news, errno, -1);
  _exit(127);
}

}  // namespace

ChildProcess::ChildProcess(const Command& command) {
  const Vectors vectors(command);
  const Confinement confinement(command.sandbox ? &*command.sandbox : nullptr,
                                command.record_opened, command.seconds);
  Ends out_ends = make_pipe(), err_ends = make_pipe(), news_ends = make_sockets();
  // What loses its parent becomes our child, so that it can be waited for.
  static const int adopts = prctl(PR_SET_CHILD_SUBREAPER, 1);
  static_cast<void>(adopts);
  const pid_t parent = getpid();
  id_ = fork();
  if (id_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (id_ == 0) {
    become(command, vectors, confinement, parent, out_ends.write.get(), err_ends.write.get(),
           news_ends.write.get());
  }
  setpgid(id_, id_);  // in both: whoever comes first
  ended = Descriptor(static_cast<int>(syscall(SYS_pidfd_open, id_, 0)));
  out = std::move(out_ends.read);
  err = std::move(err_ends.read);
  news = std::move(news_ends.read);
}

ChildProcess::~ChildProcess() {
  end();
}

ChildProcess::News ChildProcess::read_news() {
  News told;
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
  iovec part{&told.failure, sizeof told.failure};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control.data();
  message.msg_controllen = control.size();
  if (recvmsg(news.get(), &message, MSG_CMSG_CLOEXEC) <= 0) {
    told.begun = true;
    return told;
  }
  const cmsghdr* header = CMSG_FIRSTHDR(&message);
  if (header != nullptr && header->cmsg_type == SCM_RIGHTS) {
    int listener = -1;
    std::memcpy(&listener, CMSG_DATA(header), sizeof listener);
    told.listener = Descriptor(listener);
  }
  return told;
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
  id_ = -1;
  return status_;
}

}  // namespace mjcourse
