#include "process/launch.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <string_view>
#include <utility>

#include "base/arithmetic.h"
#include "process/launch_news.h"

namespace mjcourse {
namespace {

// Whether the command sets the variable of "NAME=value" itself. Of two with one name, getenv finds
// the first and a shell keeps the last.
bool sets(const Command& command, std::string_view variable) {
  const std::string_view name = variable.substr(0, variable.find('='));
  return std::any_of(command.environment.begin(), command.environment.end(),
                     [&](std::string_view own) { return own.substr(0, own.find('=')) == name; });
}

}  // namespace

Launch::Launch(const Command& command, Ends ends)
    : command_(command),
      confinement_(command.sandbox ? &*command.sandbox : nullptr, command.record_opened,
                   command.seconds),
      parent_(getpid()),
      killer_(GroupKiller::instance()),
      ends_(std::move(ends)) {
  if (command.sandbox) {
    fixed_ = {"HOME=" + command.folder, "TMPDIR=" + command.folder, "LC_ALL=C.UTF-8",
              "PATH=/usr/local/bin:/usr/bin:/bin", std::string("GLIBC_TUNABLES=") + kOneRounding};
  }
  for (const std::string& a : command.arguments) arguments_.push_back(const_cast<char*>(a.c_str()));
  for (const std::string& e : command.environment) {
    environment_.push_back(const_cast<char*>(e.c_str()));
  }
  for (const std::string& f : fixed_) {
    if (!sets(command, f)) environment_.push_back(const_cast<char*>(f.c_str()));
  }
  for (char** e = environ; *e != nullptr; ++e) {
    // Of our own, a program in a sandbox gets nothing: no secrets, and no one's settings.
    if (!command.sandbox && !sets(command, *e)) environment_.push_back(*e);
  }
  arguments_.push_back(nullptr);
  environment_.push_back(nullptr);
}

bool Launch::go() {
  // A handler of ours would run in the child as well, and in our memory.
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  // The header says what the child keeps to. NOLINTBEGIN(clang-analyzer-*fork)
  const pid_t child = vfork();
  if (child == 0) become();
  // NOLINTEND(clang-analyzer-*fork)
  const int failure = errno;
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  // Memory that had another user for a moment does not show itself to its own any more.
  if (confinement_.changes_user()) prctl(PR_SET_DUMPABLE, 1);
  if (child < 0) tell_failure(ends_.news.get(), failure);
  // What is read to its end must have no other writer.
  for (Descriptor* end : {&ends_.in, &ends_.out, &ends_.err, &ends_.news}) end->reset();
  return child > 0;
}

void Launch::become() const {
  setpgid(0, 0);
  // A generator that is killed takes its programs along; one that never ends would go on for ever.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent_) _exit(127);
  // Nor does what it starts itself.
  killer_.watch(getpid());
  const int news = ends_.news.get();
  tell_id(news, getpid());
  dup2(ends_.in.is_open() ? ends_.in.get() : open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(ends_.out.get(), STDOUT_FILENO);
  dup2(ends_.err.get(), STDERR_FILENO);
  // The script engine installs handlers and the launcher may ignore signals: start clean.
  for (const int number : {SIGPIPE, SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGCHLD, SIGUSR1})
    signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  if (command_.folder.empty() || chdir(command_.folder.c_str()) == 0) {
    int listener = -1;
    errno = confinement_.enter(listener);
    if (errno == 0) {
      if (listener >= 0) tell_listener(news, listener);
      execvpe(arguments_[0], arguments_.data(), environment_.data());
    }
  }
  tell_failure(news, errno);
  _exit(127);
}

}  // namespace mjcourse
