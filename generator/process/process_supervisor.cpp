#include "process/process_supervisor.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "base/cancellation.h"
#include "base/folder_size.h"
#include "process/group_use.h"

namespace mjcourse {
namespace {

using std::chrono::milliseconds;
using End = Outcome::End;

// How often the files are counted that a program writes: as often as it may write them all, for
// a program that may write much mostly writes little.
constexpr milliseconds kCountFiles{20};
constexpr std::uint64_t kWritten = 8 << 20;  // bytes, in a millisecond
// And what its processes hold together, which takes longer to find out.
constexpr milliseconds kCountUse{100};
// How often a kernel that cannot tell of a child's end is asked for it.
constexpr milliseconds kAskForEnd{1};
// How often somebody is asked whether the program is still wanted.
constexpr milliseconds kAskForWish{20};

milliseconds between_counts(const Command& command) {
  const std::uint64_t bytes = command.sandbox ? command.sandbox->folder_bytes : 0;
  return std::max(kCountFiles, milliseconds(bytes / kWritten));
}

// Read what is there; false at the end of the stream.
bool drain(int descriptor, std::string& into) {
  std::array<char, 16384> buffer;
  const ssize_t count = read(descriptor, buffer.data(), buffer.size());
  if (count > 0) into.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && errno == EINTR);
}

constexpr std::size_t kMostHeard = 16 << 20;  // bytes

// Of a question, and of an answer.
constexpr std::size_t kSizeBytes = sizeof(std::uint64_t);

}  // namespace

ProcessSupervisor::ProcessSupervisor(const Command& command)
    : command_(command),
      child_(command),
      next_count_(Clock::now() + between_counts(command)),
      next_use_(Clock::now() + kCountUse),
      hears_(command.hears != nullptr) {
  outcome_.end = End::exited;
  if (command.sandbox) watcher_.emplace(child_.id(), *command.sandbox);
}

Outcome ProcessSupervisor::run() {
  allow(command_.seconds);
  while (!over_ && (!ended_ || child_.out.is_open() || child_.err.is_open() || hears_)) {
    wait_and_serve();
  }
  return conclude();
}

tl::expected<std::string, Outcome> ProcessSupervisor::ask(std::string_view question,
                                                          double seconds) {
  allow(seconds);
  const std::uint64_t size = question.size();
  to_say_.assign(reinterpret_cast<const char*>(&size), kSizeBytes).append(question);
  outcome_.err.clear();
  while (!over_ && !ended_) {
    wait_and_serve();
    if (auto answer = take_answer()) return *std::move(answer);
  }
  return tl::unexpected(conclude());
}

std::optional<std::string> ProcessSupervisor::take_answer() {
  std::uint64_t size = 0;
  if (outcome_.out.size() < kSizeBytes) return std::nullopt;
  std::memcpy(&size, outcome_.out.data(), kSizeBytes);
  if (outcome_.out.size() - kSizeBytes < size) return std::nullopt;
  std::string answer = std::move(outcome_.out);
  outcome_.out.clear();
  answer.resize(kSizeBytes + static_cast<std::size_t>(size));
  answer.erase(0, kSizeBytes);
  return answer;
}

Outcome ProcessSupervisor::conclude() {
  if (!ended_) status_ = child_.end();
  ended_ = true;
  if (outcome_.end == End::exited && WIFSIGNALED(status_)) {
    outcome_.end = End::killed_by_signal;
    outcome_.code = WTERMSIG(status_);
  } else if (outcome_.end == End::exited) {
    outcome_.code = WEXITSTATUS(status_);
  }
  if (watched_ && command_.record_opened) outcome_.opened = watcher_->opened();
  return std::move(outcome_);
}

void ProcessSupervisor::allow(double seconds) {
  deadline_ = Clock::now() +
              std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

void ProcessSupervisor::say() {
  const ssize_t count =
      send(child_.in.get(), to_say_.data(), to_say_.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  if (count > 0) to_say_.erase(0, static_cast<std::size_t>(count));
  if (count < 0 && errno != EAGAIN && errno != EINTR) to_say_.clear();  // it will have ended
}

void ProcessSupervisor::hear() {
  const std::size_t before = heard_.size();
  if (!drain(child_.in.get(), heard_)) hears_ = false;
  heard_bytes_ += heard_.size() - before;
  std::size_t begin = 0;
  for (std::size_t end; (end = heard_.find('\n', begin)) != heard_.npos; begin = end + 1) {
    to_say_ += command_.hears(std::string_view(heard_).substr(begin, end - begin));
  }
  heard_.erase(0, begin);
  if (heard_bytes_ > kMostHeard) stop(End::flooded);
}

void ProcessSupervisor::stop(End end) {
  outcome_.end = end;
  over_ = true;
}

int ProcessSupervisor::patience() const {
  Clock::time_point until = deadline_;
  if (command_.sandbox) until = std::min({until, next_count_, next_use_});
  if (cancellation().stop_possible()) until = std::min(until, Clock::now() + kAskForWish);
  if (!child_.ended.is_open() && !ended_) until = std::min(until, Clock::now() + kAskForEnd);
  return static_cast<int>(
      std::max<std::int64_t>(0, std::chrono::ceil<milliseconds>(until - Clock::now()).count()));
}

void ProcessSupervisor::wait_and_serve() {
  const bool talks = hears_ || !to_say_.empty();
  const auto talk = static_cast<short>((hears_ ? POLLIN : 0) | (to_say_.empty() ? 0 : POLLOUT));
  // A closed one is -1, which poll passes over.
  std::array<pollfd, 6> open{{{child_.news.get(), POLLIN, 0},
                              {listener_.get(), POLLIN, 0},
                              {child_.out.get(), POLLIN, 0},
                              {child_.err.get(), POLLIN, 0},
                              {ended_ ? -1 : child_.ended.get(), POLLIN, 0},
                              {talks ? child_.in.get() : -1, talk, 0}}};
  const bool ready = poll(open.data(), open.size(), patience()) > 0;
  end_if_cancelled();  // which kills the child
  if (Clock::now() >= deadline_) return stop(End::timed_out);
  if (ready && open[0].revents != 0) hear_news();
  if (ready && open[1].revents != 0) answer(open[1].revents);
  if (ready && open[2].revents != 0) collect(child_.out, outcome_.out);
  if (ready && open[3].revents != 0) collect(child_.err, outcome_.err);
  if (ready && hears_ && (open[5].revents & ~POLLOUT) != 0) hear();
  if (ready && !to_say_.empty() && open[5].revents != 0) say();
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

void ProcessSupervisor::hear_news() {
  LaunchNews news = read_launch_news(child_.news.get());
  if (news.failure != 0) {
    outcome_.code = news.failure;
    stop(End::not_started);
  }
  if (news.listener.is_open() && watcher_) {
    listener_ = std::move(news.listener);
    watched_ = true;
  }
  if (news.begun) child_.news.reset();
}

void ProcessSupervisor::answer(short events) {
  if ((events & POLLIN) != 0) watcher_->answer(listener_.get());
  if ((events & POLLIN) == 0) listener_.reset();  // nobody is left to ask
  if (watcher_->refused().empty()) return;
  outcome_.refused = watcher_->refused();
  stop(End::refused);
}

void ProcessSupervisor::collect(Descriptor& stream, std::string& text) {
  if (!drain(stream.get(), text)) stream.reset();
  if (text.size() <= command_.output_bytes) return;
  text.resize(command_.output_bytes);
  stop(End::flooded);
}

void ProcessSupervisor::count_use() {
  const Sandbox& sandbox = *command_.sandbox;
  const GroupUse use = use_of_group(child_.id(), sandbox);
  removed_ = use.removed;
  if (sandbox.processes && use.memory > sandbox.memory_bytes) stop(End::exhausted);
  next_use_ = Clock::now() + kCountUse;
}

void ProcessSupervisor::count_files() {
  FolderSize size;
  size.bytes = removed_;
  for (const std::string& path : command_.sandbox->write) {
    add_size(path, command_.sandbox->folder_entries, size);
  }
  if (size.bytes > command_.sandbox->folder_bytes ||
      size.entries > command_.sandbox->folder_entries) {
    stop(End::overfilled);
  }
  next_count_ = Clock::now() + between_counts(command_);
}

Outcome run(const Command& command) {
  return ProcessSupervisor(command).run();
}

}  // namespace mjcourse
