#include "session/folder_watch.h"

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <system_error>
#include <utility>

#include "base/beneath.h"
#include "base/descriptor.h"
#include "base/editor_files.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kQuiet = 1;      // ms without an event end a change
constexpr int kComeBack = 40;  // ms, where a file is gone
constexpr int kAtMost = 300;   // ms: a program that writes all the time is not waited for
constexpr int kLookForStop = 100;

constexpr unsigned kEvents = IN_CLOSE_WRITE | IN_CREATE | IN_DELETE | IN_MOVED_FROM | IN_MOVED_TO |
                             IN_DELETE_SELF | IN_MOVE_SELF | IN_ONLYDIR;

bool is_in(const fs::path& path, const fs::path& folder) {
  const auto [end, ignored] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end == folder.end();
}

}  // namespace

FolderWatch::FolderWatch(const std::vector<fs::path>& folders)
    : notify_(inotify_init1(IN_CLOEXEC | IN_NONBLOCK)) {
  if (notify_ < 0 && errno == EMFILE) {
    throw std::system_error(errno, std::generic_category(),
                            "too many programs watch folders; end one, or raise "
                            "fs.inotify.max_user_instances");
  }
  if (notify_ < 0) throw_errno("inotify");
  for (const fs::path& folder : folders) {
    folders_.push_back(fs::absolute(folder).lexically_normal());
  }
  watch_all();
}

FolderWatch::~FolderWatch() {
  close(notify_);
}

bool FolderWatch::is_ours(const fs::path& path) const {
  return std::ranges::any_of(folders_,
                             [&](const fs::path& folder) { return is_in(path, folder); }) ||
         std::ranges::any_of(targets_, [&](const auto& link) { return is_in(path, link.second); });
}

void FolderWatch::watch(const fs::path& folder) {
  const int number = inotify_add_watch(notify_, folder.c_str(), kEvents);
  if (number >= 0) {
    watched_[number] = folder;
  } else if (errno == ENOSPC) {
    throw std::system_error(errno, std::generic_category(),
                            "too many folders are watched on this machine; raise "
                            "fs.inotify.max_user_watches to watch " +
                                folder.string());
  }  // else it is gone already, or is not a folder
}

void FolderWatch::watch_below(const fs::path& folder) {
  watch(folder);
  std::error_code gone;
  fs::recursive_directory_iterator entries(folder, fs::directory_options::skip_permission_denied,
                                           gone);
  for (; !gone && entries != fs::recursive_directory_iterator(); entries.increment(gone)) {
    const bool is_folder = entries->is_directory(gone) && !entries->is_symlink(gone);
    if (!is_of_editor(entries->path().filename().string())) {
      if (entries->is_symlink(gone)) watch_target(entries->path());
      if (is_folder) watch(entries->path());
    } else if (is_folder) {
      entries.disable_recursion_pending();
    }
  }
}

void FolderWatch::watch_target(const fs::path& link) {
  for (const fs::path& folder : folders_) {
    if (!is_in(link, folder)) continue;
    const fs::path course = folder.parent_path();
    const auto name = Beneath(course).target(link.lexically_relative(course).string());
    const fs::path target = name ? course / *name : fs::path();
    if (!name || targets_[link] == target) continue;
    targets_[link] = target;
    std::error_code gone;
    if (fs::is_directory(target, gone)) {
      watch_below(target);
    } else {
      watch(target.parent_path());
    }
  }
}

// A folder that was moved away is still watched, under a name that it no longer has.
void FolderWatch::forget_below(const fs::path& folder) {
  for (auto it = watched_.begin(); it != watched_.end();) {
    if (is_in(it->second, folder)) {
      inotify_rm_watch(notify_, it->first);
      it = watched_.erase(it);
    } else {
      ++it;
    }
  }
}

void FolderWatch::watch_all() {
  for (const fs::path& folder : folders_) {
    watch(folder.parent_path());
    std::error_code gone;
    if (fs::is_symlink(folder, gone)) watch_target(folder);
    watch_below(folder);
  }
}

bool FolderWatch::poll_for(int milliseconds, const std::stop_token& stop) const {
  const auto until = Clock::now() + std::chrono::milliseconds(milliseconds);
  while (!stop.stop_requested()) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now()).count();
    if (milliseconds >= 0 && left <= 0) return false;
    const int patience =
        milliseconds < 0 ? kLookForStop : std::min<int>(static_cast<int>(left), kLookForStop);
    pollfd ready{notify_, POLLIN, 0};
    if (poll(&ready, 1, patience) > 0) return true;
  }
  return false;
}

void FolderWatch::add(const fs::path& path) {
  changed_.insert(path);
  for (const auto& [link, target] : targets_) {
    if (path == target) {
      changed_.insert(link);
    } else if (is_in(path, target)) {
      changed_.insert(link / path.lexically_relative(target));
    }
  }
}

void FolderWatch::take(unsigned mask, const fs::path& path) {
  const bool is_folder = (mask & IN_ISDIR) != 0;
  if (is_folder && (mask & (IN_CREATE | IN_MOVED_TO)) != 0 && is_ours(path)) {
    // What is in it already was perhaps there before it was watched.
    watch_below(path);
  }
  if (is_folder && (mask & (IN_MOVED_FROM | IN_DELETE)) != 0) forget_below(path);
  if (!is_ours(path)) return;
  std::error_code unlinked;
  if (fs::is_symlink(path, unlinked)) watch_target(path);
  // A file that is created is told again when it is closed; a link is complete at once.
  std::error_code gone;
  const bool unwritten = mask == IN_CREATE && fs::is_regular_file(fs::symlink_status(path, gone)) &&
                         fs::hard_link_count(path, gone) == 1;
  if (unwritten) return;
  if ((mask & (IN_MOVED_FROM | IN_DELETE)) != 0) {
    gone_.insert(path);
  } else {
    gone_.erase(path);
  }
  add(path);
}

void FolderWatch::read_events() {
  alignas(inotify_event) std::array<char, 65536> buffer;
  for (;;) {
    const ssize_t size = read(notify_, buffer.data(), buffer.size());
    if (size <= 0) return;
    for (const char* at = buffer.data(); at < buffer.data() + size;) {
      const auto* event = reinterpret_cast<const inotify_event*>(at);
      at += sizeof(inotify_event) + event->len;
      if ((event->mask & IN_Q_OVERFLOW) != 0) {
        watch_all();
        changed_.insert(folders_.begin(), folders_.end());
        continue;
      }
      const auto folder = watched_.find(event->wd);
      if (folder == watched_.end()) continue;
      if ((event->mask & IN_IGNORED) != 0) {
        watched_.erase(folder);
        continue;
      }
      const std::string name = event->len > 0 ? event->name : "";
      if (!name.empty() && !is_of_editor(name)) take(event->mask, folder->second / name);
    }
  }
}

std::set<fs::path> FolderWatch::wait(const std::stop_token& stop) {
  changed_.clear();
  gone_.clear();
  while (changed_.empty()) {
    if (!poll_for(-1, stop)) return {};
    read_events();
  }
  const auto begin = Clock::now();
  while (Clock::now() - begin < std::chrono::milliseconds(kAtMost) &&
         poll_for(gone_.empty() ? kQuiet : kComeBack, stop)) {
    read_events();
  }
  return changed_;
}

}  // namespace mjcourse
