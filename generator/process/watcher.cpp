#include "process/watcher.h"

#include <fcntl.h>
#include <linux/sched.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <new>
#include <utility>

#include "process/file_change.h"
#include "process/process_memory.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// Folders of the system, of whose files nobody keeps account.
constexpr std::array<std::string_view, 12> kSystemFolders{"/usr",    "/lib",  "/lib32", "/lib64",
                                                          "/libx32", "/bin",  "/sbin",  "/opt",
                                                          "/etc",    "/proc", "/sys",   "/dev"};

// A device that Mesa 25 tries when a program draws, and does without where it may not.
constexpr std::string_view kTriedDevice = "/dev/udmabuf";

std::vector<std::string> real_paths(const std::vector<std::string>& paths) {
  std::vector<std::string> real;
  for (const std::string& path : paths) {
    std::error_code error;
    const fs::path found = fs::weakly_canonical(path, error);
    real.push_back(error ? path : found.string());
  }
  return real;
}

template <typename Folders>
bool is_in_any(std::string_view path, const Folders& folders) {
  return std::any_of(folders.begin(), folders.end(),
                     [&](std::string_view folder) { return is_within(path, folder); });
}

// Without `.`, `..` and a slash at its end. What `..` leads to depends on links before it.
std::string normal_path(const std::string& path) {
  std::error_code error;
  const bool climbs = path.find("/..") != path.npos;
  const fs::path normal = climbs ? fs::weakly_canonical(path, error) : fs::path(path);
  std::string text = (error ? fs::path(path) : normal).lexically_normal().string();
  if (text.size() > 1 && text.ends_with('/')) text.pop_back();
  return text;
}

// A question and its answer; their sizes are the kernel's.
struct Exchange {
  seccomp_notif* question = nullptr;
  seccomp_notif_resp* response = nullptr;
  Exchange() {
    if (seccomp_notify_alloc(&question, &response) != 0) throw std::bad_alloc();
  }
  ~Exchange() { seccomp_notify_free(question, response); }
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;
};

bool is_scheduling(int number) {
  return number == SCMP_SYS(sched_setaffinity) || number == SCMP_SYS(sched_setscheduler) ||
         number == SCMP_SYS(sched_setparam) || number == SCMP_SYS(sched_setattr);
}

bool calls_path(int number) {
  const auto calls = path_calls();
  return std::any_of(calls.begin(), calls.end(),
                     [&](const PathCall& call) { return call.number == number; });
}

}  // namespace

Watcher::Watcher(pid_t program, const Sandbox& sandbox)
    : program_(program),
      sandbox_(sandbox),
      readable_(real_paths(sandbox.read)),
      writable_(real_paths(sandbox.write)) {
  readable_.push_back("/proc/" + std::to_string(program));
}

std::optional<std::vector<std::string>> Watcher::opened() const {
  if (!all_known_) return std::nullopt;
  return std::vector<std::string>(opened_.begin(), opened_.end());
}

void Watcher::answer(int listener) {
  const Exchange exchange;  // the kernel wants it empty each time
  if (seccomp_notify_receive(listener, exchange.question) != 0) return;  // it was killed meanwhile
  const Reply reply = decide(*exchange.question);
  if (reply.answer == Answer::stop) return;
  exchange.response->id = exchange.question->id;
  exchange.response->error = reply.answer == Answer::give ? -reply.error : 0;
  if (reply.answer == Answer::go_on) exchange.response->flags = SECCOMP_USER_NOTIF_FLAG_CONTINUE;
  seccomp_notify_respond(listener, exchange.response);
}

Watcher::Reply Watcher::decide(const seccomp_notif& question) {
  const int call = question.data.nr;
  // Of commands, a change that they may not make fails, and does not end them.
  if (calls_path(call) && !(sandbox_.processes && is_file_change(call))) {
    for (const PathCall& known : path_calls()) {
      if (known.number != call) continue;
      const Reply reply = decide_on_path(question, known);
      if (reply.answer != Answer::go_on) return reply;
    }
    if (!is_file_change(call)) return {};
  }
  if (call == SCMP_SYS(execve) || call == SCMP_SYS(execveat)) {
    if (std::exchange(begun_, true)) return refuse("start another program");
    return {};  // the one that made it what it is
  }
  if (call == SCMP_SYS(clone)) return decide_on_clone(question);
  if (call == SCMP_SYS(fork) || call == SCMP_SYS(vfork)) return refuse("start another process");
  if (call == SCMP_SYS(socket)) return refuse("open a network connection");
  if (is_file_change(call)) {
    return {Answer::give, change_file(question, {writable_, sandbox_.file_bytes})};
  }
  return decide_on_thread(question);
}

Watcher::Reply Watcher::refuse(std::string what) {
  refused_ = std::move(what);
  return {Answer::stop};
}

Watcher::Reply Watcher::decide_on_clone(const seccomp_notif& question) {
  if ((question.data.args[0] & CLONE_THREAD) == 0) return refuse("start another process");
  if (count_threads(program_) >= kMostThreads) return {Answer::give, EAGAIN};
  return {};
}

// A signal, or the scheduler's rule, for the process whose number is the first argument.
Watcher::Reply Watcher::decide_on_thread(const seccomp_notif& question) {
  const auto target = static_cast<pid_t>(question.data.args[0]);
  if (target > 0 && shares_process(target, static_cast<pid_t>(question.pid))) return {};
  const bool is_rule = is_scheduling(question.data.nr);
  if (is_rule || sandbox_.processes) return {Answer::give, EPERM};
  return refuse("send a signal to another process");
}

FileAccess Watcher::access_of(const seccomp_notif& question, const PathCall& call) {
  if (call.access != FileAccess::by_flags && call.access != FileAccess::by_struct) {
    return call.access;
  }
  std::uint64_t flags = question.data.args[call.flags];
  if (call.access == FileAccess::by_struct) {
    flags = read_number(static_cast<pid_t>(question.pid), flags).value_or(O_RDWR);
  }
  if ((flags & O_PATH) != 0) return FileAccess::look;
  const bool reads = (flags & O_ACCMODE) == O_RDONLY && (flags & (O_CREAT | O_TRUNC)) == 0;
  return reads ? FileAccess::read : FileAccess::write;
}

bool Watcher::may(const std::string& path, bool write) const {
  if (is_in_any(path, writable_system_paths())) return true;
  if (!write && is_in_any(path, readable_system_paths())) return true;
  std::error_code error;
  const std::string real = fs::weakly_canonical(path, error).string();
  if (is_in_any(real, writable_)) return true;
  if (write) return false;
  return is_in_any(real, readable_) || is_in_any(real, readable_system_paths()) ||
         !fs::exists(real, error);
}

Watcher::Reply Watcher::decide_on_path(const seccomp_notif& question, const PathCall& call) {
  const auto asker = static_cast<pid_t>(question.pid);
  const auto text = read_text(asker, question.data.args[call.path]);
  if (!text) {
    // A program that gives no text has the kernel's own answer to that; whose memory we may not
    // read, may have named anything.
    if (text.error() != EFAULT) all_known_ = false;
    return {};
  }
  if (text->empty()) return {};  // of a descriptor, whose file was asked about when it was opened
  const int folder = call.folder < 0 ? AT_FDCWD : static_cast<int>(question.data.args[call.folder]);
  const auto path = absolute_path(asker, folder, *text);
  if (!path) {
    all_known_ = false;
    return {};
  }
  const std::string normal = normal_path(*path);
  const bool own = is_in_any(normal, writable_) || is_in_any(normal, sandbox_.write);
  const FileAccess access = access_of(question, call);
  const bool looks = access == FileAccess::look;
  // realpath(3) looks at the folders that its own are in, which are of our choice.
  const bool above = looks && std::ranges::any_of(writable_, [&](const std::string& own_folder) {
                       return is_within(own_folder, normal);
                     });
  if (!own && !above && !is_in_any(normal, kSystemFolders)) opened_.insert(normal);
  if (looks) return {};
  const bool writes = access == FileAccess::write;
  if (may(normal, writes)) return {};
  if (normal == kTriedDevice) return {Answer::give, EACCES};
  return refuse((writes ? "write " : "read ") + *text);
}

}  // namespace mjcourse
