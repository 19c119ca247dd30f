#include "base/subprocess.h"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>

#include "base/cancellation.h"
#include "base/child_process.h"
#include "base/folder_size.h"
#include "base/group_use.h"
#include "base/watcher.h"

namespace mjcourse {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;
using End = Outcome::End;

// How often the files are counted that a program writes.
constexpr milliseconds kCountFiles{20};
// And what its processes hold together, which takes longer to find out.
constexpr milliseconds kCountUse{100};
// How often a kernel that cannot tell of a child's end is asked for it.
constexpr milliseconds kAskForEnd{1};
// How often somebody is asked whether the program is still wanted.
constexpr milliseconds kAskForWish{20};

// Read what is there; false at the end of the stream.
bool drain(int descriptor, std::string& into) {
  std::array<char, 16384> buffer;
  const ssize_t count = read(descriptor, buffer.data(), buffer.size());
  if (count > 0) into.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && errno == EINTR);
}

// Looks after one program from its start to its end.
class Keeper {
 public:
  explicit Keeper(const Command& command)
      : command_(command),
        deadline_(Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                     std::chrono::duration<double>(command.seconds))),
        child_(command),
        watcher_(child_.id(), command.sandbox ? &*command.sandbox : nullptr) {}

  Outcome run() {
    outcome_.end = End::exited;
    while (!over_ && (!ended_ || child_.out.is_open() || child_.err.is_open())) wait_and_serve();
    if (!ended_) status_ = child_.end();
    if (outcome_.end == End::exited && WIFSIGNALED(status_)) {
      outcome_.end = End::killed_by_signal;
      outcome_.code = WTERMSIG(status_);
    } else if (outcome_.end == End::exited) {
      outcome_.code = WEXITSTATUS(status_);
    }
    if (watched_ && command_.record_opened) outcome_.opened = watcher_.opened();
    return std::move(outcome_);
  }

 private:
  void stop(End end) {
    outcome_.end = end;
    over_ = true;
  }

  int patience() const {
    Clock::time_point until = deadline_;
    if (command_.sandbox) until = std::min({until, next_count_, next_use_});
    if (cancellation().stop_possible()) until = std::min(until, Clock::now() + kAskForWish);
    if (!child_.ended.is_open() && !ended_) until = std::min(until, Clock::now() + kAskForEnd);
    return static_cast<int>(
        std::max<std::int64_t>(0, std::chrono::ceil<milliseconds>(until - Clock::now()).count()));
  }

  void wait_and_serve() {
    // A closed one is -1, which poll passes over.
    std::array<pollfd, 5> open{{{child_.news.get(), POLLIN, 0},
                                {listener_.get(), POLLIN, 0},
                                {child_.out.get(), POLLIN, 0},
                                {child_.err.get(), POLLIN, 0},
                                {ended_ ? -1 : child_.ended.get(), POLLIN, 0}}};
    const bool ready = poll(open.data(), open.size(), patience()) > 0;
    end_if_cancelled();  // which kills the child
    if (Clock::now() >= deadline_) return stop(End::timed_out);
    if (ready && open[0].revents != 0) hear_news();
    if (ready && open[1].revents != 0) answer(open[1].revents);
    if (ready && open[2].revents != 0) collect(child_.out, outcome_.out);
    if (ready && open[3].revents != 0) collect(child_.err, outcome_.err);
    if (command_.sandbox && Clock::now() >= next_count_) count_files();
    if (command_.sandbox && !over_ && Clock::now() >= next_use_) count_use();
    const bool may_have_ended = open[4].revents != 0 || !child_.ended.is_open();
    if (!over_ && !ended_ && may_have_ended && child_.has_ended()) {
      // Its streams end with the last of what it left behind.
      status_ = child_.end();
      ended_ = true;
      listener_.reset();
    }
  }

  void hear_news() {
    LaunchNews news = read_launch_news(child_.news.get());
    if (news.failure != 0) {
      outcome_.code = news.failure;
      stop(End::not_started);
    }
    if (news.listener.is_open()) {
      listener_ = std::move(news.listener);
      watched_ = true;
    }
    if (news.begun) child_.news.reset();
  }

  void answer(short events) {
    if ((events & POLLIN) != 0) watcher_.answer(listener_.get());
    if ((events & POLLIN) == 0) listener_.reset();  // nobody is left to ask
    if (watcher_.refused().empty()) return;
    outcome_.refused = watcher_.refused();
    stop(End::refused);
  }

  void collect(Descriptor& stream, std::string& text) {
    if (!drain(stream.get(), text)) stream.reset();
    if (text.size() <= command_.output_bytes) return;
    text.resize(command_.output_bytes);
    stop(End::flooded);
  }

  void count_use() {
    const Sandbox& sandbox = *command_.sandbox;
    const GroupUse use = use_of_group(child_.id(), !sandbox.processes);
    removed_ = use.removed;
    if (sandbox.processes && use.memory > sandbox.memory_bytes) stop(End::exhausted);
    next_use_ = Clock::now() + kCountUse;
  }

  void count_files() {
    FolderSize size;
    size.bytes = removed_;
    for (const std::string& path : command_.sandbox->write) {
      add_size(path, command_.sandbox->folder_entries, size);
    }
    if (size.bytes > command_.sandbox->folder_bytes ||
        size.entries > command_.sandbox->folder_entries) {
      stop(End::overfilled);
    }
    next_count_ = Clock::now() + kCountFiles;
  }

  const Command& command_;
  const Clock::time_point deadline_;
  ChildProcess child_;
  Watcher watcher_;
  Descriptor listener_;
  Clock::time_point next_count_ = Clock::now() + kCountFiles;
  Clock::time_point next_use_ = Clock::now() + kCountUse;
  std::uint64_t removed_ = 0;  // bytes of files that no folder has
  Outcome outcome_;
  int status_ = 0;
  bool watched_ = false, ended_ = false, over_ = false;
};

}  // namespace

Outcome run(const Command& command) {
  return Keeper(command).run();
}

}  // namespace mjcourse
