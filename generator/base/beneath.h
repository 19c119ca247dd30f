// Opening what lies beneath a folder, and nothing that only seems to. A course is often somebody
// else's. A link in it may lead to what only its reader may read, and a pipe may lie in it that
// nobody ever writes into.
//
// A link is followed as long as each step of its way stays beneath the folder; nothing in `.git` is
// opened. Names are resolved one by one from descriptors, so what is swapped meanwhile leads
// nowhere else. Where a path has no link, which is nearly always, the kernel does all of it in one
// call. A path of more than a hundred folders is refused as well.
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "base/descriptor.h"

namespace mjcourse {

// Why something that is there is never opened, and what the course's author does then.
struct FileRefusal {
  std::string why;  // "leads out of the course"
  std::string cure;
};

// Why something was not opened.
struct Unopened {
  int reason;          // as errno has it; 0 where it is there and is refused
  std::string why;     // "leads out of the course"
  std::string cure{};  // of what is refused

  bool is_refused() const { return reason == 0; }
  // Nothing where it only could not be opened.
  std::optional<FileRefusal> refusal() const {
    return is_refused() ? std::optional(FileRefusal{why, cure}) : std::nullopt;
  }
};

// Folders in each other, with the one beneath which a path leads. Each step of a way costs time,
// and all files of a deep folder go that way again.
inline constexpr int kMostFolders = 100;
bool is_too_deep(std::string_view path);

// What is there under a name, and is neither a file nor a folder.
FileRefusal refusal_of_no_file();

// Thrown where something would have been written that is refused: "build leads out of the course".
class RefusedPath : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
// Throws what kept from writing `path`: RefusedPath, or std::system_error.
[[noreturn]] void throw_unopened(const std::string& path, const Unopened& unopened);

class Beneath {
 public:
  // By hand: without the kernel's openat2, which is not everywhere.
  enum class Way { kernel, by_hand };

  // `root` itself may be a link. It is looked up at each call.
  explicit Beneath(std::filesystem::path root, Way way = Way::kernel)
      : root_(std::move(root)), way_(way) {}

  const std::filesystem::path& root() const { return root_; }

  // What a file is opened with and what is known of it.
  struct File {
    Descriptor descriptor;
    struct stat status;
  };
  // A plain file, to be read. Opening a pipe does not wait.
  tl::expected<File, Unopened> file(const std::string& path) const;
  // A folder, to be listed. "" and "." are the root.
  tl::expected<Descriptor, Unopened> folder(const std::string& path) const;
  // Of whatever a path leads to, which is not opened.
  tl::expected<struct stat, Unopened> status(const std::string& path) const;

  // Where something may be written: the folder, and the name in it, which is no link. The name may
  // not be there yet.
  struct Spot {
    Descriptor folder;
    std::string name;
  };
  enum class Missing { fails, is_made };
  // The folders on the way are made where they are `missing`.
  tl::expected<Spot, Unopened> spot(const std::string& path, Missing missing) const;

  // The path beneath the root at which `path` ends, without links; it need not be there.
  tl::expected<std::string, Unopened> target(const std::string& path) const;

 private:
  std::filesystem::path root_;
  Way way_;
};

// The part of `path` beneath `root`, where the one begins with the other; not resolved. Nothing for
// any other path.
tl::expected<std::string, Unopened> name_beneath(const std::filesystem::path& root,
                                                 const std::filesystem::path& path);

}  // namespace mjcourse
