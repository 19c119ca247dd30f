#include "base/beneath.h"

#include <fcntl.h>
#include <linux/openat2.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <deque>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // as the kernel follows
constexpr int kReads = O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
constexpr int kPoints = O_PATH | O_CLOEXEC;
constexpr int kLists = O_RDONLY | O_DIRECTORY | O_CLOEXEC;

tl::unexpected<Unopened> failed(int reason) {
  return tl::unexpected(Unopened{reason, std::generic_category().message(reason)});
}

tl::unexpected<Unopened> refused(FileRefusal refusal) {
  return tl::unexpected(Unopened{0, std::move(refusal.why), std::move(refusal.cure)});
}

tl::unexpected<Unopened> leads_out() {
  return refused({"leads out of the course",
                  "a course is made of its own files: put a copy there, or a link that stays "
                  "inside of the course"});
}

tl::unexpected<Unopened> lies_too_deep() {
  return refused({"lies in more than " + std::to_string(kMostFolders) + " folders in each other",
                  "move it into a folder further up"});
}

bool is_gits(std::string_view name) {
  return name == ".git";
}

std::deque<std::string> names_of(std::string_view path) {
  std::deque<std::string> names;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    if (end > begin) names.emplace_back(path.substr(begin, end - begin));
    begin = end + 1;
  }
  return names;
}

bool names_gits(const std::string& path) {
  return path.find(".git") != path.npos && std::ranges::any_of(names_of(path), is_gits);
}

// The kernel's own way, for a path without a link; nothing where it has to be walked.
std::optional<tl::expected<Descriptor, Unopened>> open_at_once(int root, const std::string& path,
                                                               int flags) {
  if (is_too_deep(path)) return lies_too_deep();
  if (names_gits(path)) return std::nullopt;
  open_how how{};
  how.flags = static_cast<unsigned>(flags);
  how.resolve = RESOLVE_BENEATH | RESOLVE_NO_SYMLINKS | RESOLVE_NO_MAGICLINKS;
  const char* const name = path.empty() ? "." : path.c_str();
  const auto number = static_cast<int>(syscall(SYS_openat2, root, name, &how, sizeof how));
  if (number >= 0) return Descriptor(number);
  const int reason = errno;
  const bool is_answer = reason == ENOENT || reason == ENOTDIR || reason == EACCES ||
                         reason == ENAMETOOLONG || reason == EMFILE || reason == ENFILE;
  if (is_answer) return failed(reason);
  return std::nullopt;  // a link, a step out, or a kernel that does not know the call
}

std::string text_of_link(int link) {
  std::array<char, PATH_MAX> text{};
  const ssize_t size = readlinkat(link, "", text.data(), text.size());
  return size < 0 ? "" : std::string(text.data(), static_cast<std::size_t>(size));
}

// A walk from the root, name by name; each folder on the way stays open, so that `..` is the one it
// came from.
class Walk {
 public:
  Walk(const fs::path& root, Beneath::Missing missing) : root_(root), missing_(missing) {}

  // Where it ends.
  struct End {
    std::string name;  // in the last folder; "" where that is the end itself
    Descriptor place;  // not open where there is nothing of the name
    struct stat status {};
  };

  tl::expected<End, Unopened> to(const std::string& path) {
    Descriptor root(open(root_.c_str(), kPoints | O_DIRECTORY));
    if (!root.is_open()) return failed(errno);
    folders_.push_back(std::move(root));
    if (path.starts_with('/')) return leads_out();
    rest_ = names_of(path);
    while (!rest_.empty()) {
      const std::string name = std::move(rest_.front());
      rest_.pop_front();
      if (name == ".") continue;
      if (name == "..") {
        if (folders_.size() == 1) return leads_out();
        folders_.pop_back();
        passed_.pop_back();
        continue;
      }
      if (is_gits(name)) {
        return refused({"lies in .git, which is no part of the course",
                        "put a copy of it into another folder of the course, and name that"});
      }
      auto end = step(name);
      if (!end) return tl::unexpected(end.error());
      if (*end) return **std::move(end);
    }
    End end;
    if (fstat(folder(), &end.status) != 0) return failed(errno);
    end.place = Descriptor(fcntl(folder(), F_DUPFD_CLOEXEC, 0));
    return end;
  }

  int folder() const { return folders_.back().get(); }
  Descriptor take_folder() { return std::move(folders_.back()); }
  // The names of the folders it went through.
  const std::vector<std::string>& passed() const { return passed_; }

 private:
  // Into `name`; the end, where this is it.
  tl::expected<std::optional<End>, Unopened> step(const std::string& name) {
    const bool is_last = rest_.empty();
    Descriptor place(openat(folder(), name.c_str(), kPoints | O_NOFOLLOW));
    if (!place.is_open() && errno == ENOENT && !is_last && missing_ == Beneath::Missing::is_made) {
      if (mkdirat(folder(), name.c_str(), 0777) != 0 && errno != EEXIST) return failed(errno);
      place = Descriptor(openat(folder(), name.c_str(), kPoints | O_NOFOLLOW));
    }
    if (!place.is_open()) {
      if (errno == ENOENT && is_last) return End{name, Descriptor(), {}};
      return failed(errno);
    }
    struct stat status {};
    if (fstat(place.get(), &status) != 0) return failed(errno);
    if (S_ISLNK(status.st_mode)) return follow(text_of_link(place.get()));
    if (is_last) return End{name, std::move(place), status};
    if (!S_ISDIR(status.st_mode)) return failed(ENOTDIR);
    if (std::cmp_equal(folders_.size(), kMostFolders)) return lies_too_deep();
    folders_.push_back(std::move(place));
    passed_.push_back(name);
    return std::nullopt;
  }

  tl::expected<std::optional<End>, Unopened> follow(const std::string& link) {
    if (++links_ > kMostLinks) {
      return refused({"is a link that leads in a circle",
                      "put the file itself there, or a link to a file of the course"});
    }
    if (link.empty()) return failed(ENOENT);
    std::string below = link;
    if (link.front() == '/') {
      std::error_code none;
      const auto inside = name_beneath(fs::canonical(root_, none), link);
      if (none || !inside) return leads_out();
      below = *inside;
      folders_.resize(1);
      passed_.clear();
    }
    std::deque<std::string> names = names_of(below);
    rest_.insert(rest_.begin(), names.begin(), names.end());
    return std::nullopt;
  }

  const fs::path& root_;
  Beneath::Missing missing_;
  std::vector<Descriptor> folders_;
  std::vector<std::string> passed_;
  std::deque<std::string> rest_;
  int links_ = 0;
};

tl::expected<Beneath::File, Unopened> as_file(Descriptor descriptor) {
  Beneath::File file{std::move(descriptor), {}};
  if (fstat(file.descriptor.get(), &file.status) != 0) return failed(errno);
  const mode_t mode = file.status.st_mode;
  if (S_ISDIR(mode)) return tl::unexpected(Unopened{EISDIR, "is a folder, not a file"});
  if (!S_ISREG(mode)) return refused(refusal_of_no_file());
  return file;
}

tl::expected<Descriptor, Unopened> opened(int folder, const char* name, int flags) {
  Descriptor descriptor(openat(folder, name, flags | O_NOFOLLOW));
  if (!descriptor.is_open()) return failed(errno);
  return descriptor;
}

}  // namespace

bool is_too_deep(std::string_view path) {
  return std::ranges::count(path, '/') >= kMostFolders;
}

FileRefusal refusal_of_no_file() {
  return {"is neither a file nor a folder", "replace it: a pipe or a device is never read"};
}

void throw_unopened(const std::string& path, const Unopened& unopened) {
  if (unopened.is_refused()) throw RefusedPath(path + " " + unopened.why);
  throw std::system_error(unopened.reason, std::generic_category(), path);
}

tl::expected<Beneath::File, Unopened> Beneath::file(const std::string& path) const {
  if (way_ == Way::kernel) {
    const Descriptor root(open(root_.c_str(), kPoints | O_DIRECTORY));
    if (!root.is_open()) return failed(errno);
    if (auto once = open_at_once(root.get(), path, kReads)) {
      if (!*once) return tl::unexpected(once->error());
      return as_file(**std::move(once));
    }
  }
  Walk walk(root_, Missing::fails);
  auto end = walk.to(path);
  if (!end) return tl::unexpected(end.error());
  if (!end->place.is_open()) return failed(ENOENT);
  // Not opened is what is known to be no file: to open a device may do something.
  if (S_ISDIR(end->status.st_mode) || !S_ISREG(end->status.st_mode)) {
    return as_file(std::move(end->place));
  }
  auto descriptor = opened(walk.folder(), end->name.c_str(), kReads);
  if (!descriptor) return tl::unexpected(descriptor.error());
  return as_file(*std::move(descriptor));
}

tl::expected<Descriptor, Unopened> Beneath::folder(const std::string& path) const {
  if (way_ == Way::kernel) {
    const Descriptor root(open(root_.c_str(), kPoints | O_DIRECTORY));
    if (!root.is_open()) return failed(errno);
    if (auto once = open_at_once(root.get(), path, kLists)) return *std::move(once);
  }
  Walk walk(root_, Missing::fails);
  auto end = walk.to(path);
  if (!end) return tl::unexpected(end.error());
  if (!end->place.is_open()) return failed(ENOENT);
  return opened(walk.folder(), end->name.empty() ? "." : end->name.c_str(), kLists);
}

tl::expected<struct stat, Unopened> Beneath::status(const std::string& path) const {
  if (way_ == Way::kernel) {
    const Descriptor root(open(root_.c_str(), kPoints | O_DIRECTORY));
    if (!root.is_open()) return failed(errno);
    if (const auto once = open_at_once(root.get(), path, kPoints)) {
      if (!*once) return tl::unexpected(once->error());
      struct stat status {};
      if (fstat((*once)->get(), &status) != 0) return failed(errno);
      return status;
    }
  }
  Walk walk(root_, Missing::fails);
  const auto end = walk.to(path);
  if (!end) return tl::unexpected(end.error());
  if (!end->place.is_open()) return failed(ENOENT);
  return end->status;
}

tl::expected<Beneath::Spot, Unopened> Beneath::spot(const std::string& path,
                                                    Missing missing) const {
  Walk walk(root_, missing);
  const auto end = walk.to(path);
  if (!end) return tl::unexpected(end.error());
  if (end->name.empty()) return failed(EISDIR);
  return Spot{walk.take_folder(), end->name};
}

tl::expected<std::string, Unopened> Beneath::target(const std::string& path) const {
  Walk walk(root_, Missing::fails);
  const auto end = walk.to(path);
  if (!end) return tl::unexpected(end.error());
  fs::path target;
  for (const std::string& name : walk.passed()) target /= name;
  return (end->name.empty() ? target : target / end->name).string();
}

tl::expected<std::string, Unopened> name_beneath(const fs::path& root, const fs::path& path) {
  std::string folder = root.string();
  while (folder.ends_with('/')) folder.pop_back();
  const std::string& whole = path.native();
  if (whole == folder) return "";
  if (!whole.starts_with(folder + "/")) return leads_out();
  return whole.substr(folder.size() + 1);
}

}  // namespace mjcourse
