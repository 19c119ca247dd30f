#include "base/subprocess.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <string_view>
#include <system_error>

namespace mjcourse {
namespace {

using Clock = std::chrono::steady_clock;

struct Pipe {
  int read_end = -1;
  int write_end = -1;
  Pipe() {
    int ends[2];
    // Close-on-exec: a child started by another thread must not hold this pipe open.
    if (pipe2(ends, O_CLOEXEC) != 0)
      throw std::system_error(errno, std::generic_category(), "pipe");
    read_end = ends[0];
    write_end = ends[1];
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close(read_end);
    close_write();
  }
  void close_write() {
    if (write_end >= 0) close(write_end);
    write_end = -1;
  }
};

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
  explicit Vectors(const Command& command) {
    for (const std::string& a : command.arguments)
      arguments.push_back(const_cast<char*>(a.c_str()));
    for (const std::string& e : command.environment) {
      environment.push_back(const_cast<char*>(e.c_str()));
    }
    for (char** e = environ; *e != nullptr; ++e) {
      if (!sets(command, *e)) environment.push_back(*e);
    }
    arguments.push_back(nullptr);
    environment.push_back(nullptr);
  }
};

[[noreturn]] void become(const Command& command, const Vectors& vectors, int out, int err,
                         int failure) {
  setpgid(0, 0);
  // A generator that is killed takes its programs along; one that never ends would go on for ever.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  // The script engine installs handlers and the launcher may ignore signals: start clean.
  for (const int signal_number : {SIGPIPE, SIGINT, SIGTERM, SIGUSR1})
    signal(signal_number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  if (command.folder.empty() || chdir(command.folder.c_str()) == 0) {
    execvpe(vectors.arguments[0], vectors.arguments.data(), vectors.environment.data());
  }
  const int reason = errno;
  [[maybe_unused]] const ssize_t written = write(failure, &reason, sizeof reason);
  _exit(127);
}

// Read what is there; false at the end of the stream.
bool drain(int descriptor, std::string& into) {
  std::array<char, 16384> buffer;
  const ssize_t count = read(descriptor, buffer.data(), buffer.size());
  if (count > 0) into.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && errno == EINTR);
}

// Collect both streams until they end or a limit is passed.
void collect(const Command& command, int out, int err, Outcome& outcome) {
  const auto deadline = Clock::now() + std::chrono::duration<double>(command.seconds);
  std::array<pollfd, 2> streams{{{out, POLLIN, 0}, {err, POLLIN, 0}}};
  std::array<std::string*, 2> texts{&outcome.out, &outcome.err};
  while (streams[0].fd >= 0 || streams[1].fd >= 0) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) {
      outcome.end = Outcome::End::timed_out;
      return;
    }
    if (poll(streams.data(), streams.size(), static_cast<int>(left)) <= 0) continue;
    for (std::size_t i = 0; i < streams.size(); ++i) {
      if (streams[i].fd < 0 || streams[i].revents == 0) continue;
      if (!drain(streams[i].fd, *texts[i])) streams[i].fd = -1;
      if (texts[i]->size() > command.output_bytes) {
        texts[i]->resize(command.output_bytes);
        outcome.end = Outcome::End::flooded;
        return;
      }
    }
  }
}

// Wait for the program itself, which may outlive its streams, until the deadline.
int reap(pid_t child, Clock::time_point deadline, Outcome& outcome) {
  int status = 0;
  const bool stop_now = outcome.end != Outcome::End::exited;
  while (!stop_now && waitpid(child, &status, WNOHANG) == 0) {
    if (Clock::now() > deadline) {
      outcome.end = Outcome::End::timed_out;
      break;
    }
    usleep(500);
  }
  kill(-child, SIGKILL);  // whatever the program left behind goes with it
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

Outcome run(const Command& command) {
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(command.seconds));
  const Vectors vectors(command);
  Pipe out, err, failure;
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) become(command, vectors, out.write_end, err.write_end, failure.write_end);
  setpgid(child, child);  // in both: whoever comes first
  out.close_write();
  err.close_write();
  failure.close_write();

  Outcome outcome;
  int reason = 0;
  if (read(failure.read_end, &reason, sizeof reason) == sizeof reason) {
    waitpid(child, nullptr, 0);
    return {Outcome::End::not_started, reason, "", ""};
  }
  outcome.end = Outcome::End::exited;
  collect(command, out.read_end, err.read_end, outcome);
  const int status = reap(child, deadline, outcome);
  if (outcome.end != Outcome::End::exited) return outcome;
  if (WIFSIGNALED(status)) {
    outcome.end = Outcome::End::killed_by_signal;
    outcome.code = WTERMSIG(status);
  } else {
    outcome.code = WEXITSTATUS(status);
  }
  return outcome;
}

}  // namespace mjcourse
