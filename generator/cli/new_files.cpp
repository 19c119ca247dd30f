#include "cli/new_files.h"

#include <iostream>
#include <system_error>
#include <utility>

#include "base/beneath.h"
#include "base/plain_name.h"
#include "base/replace_file.h"
#include "base/utf8.h"
#include "cli/run.h"
#include "remote/store_address.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

Refusal in_the_way(const NewFile& file) {
  if (file.before) {
    return {kCourseErrors, file.path + " changed meanwhile, so nothing was written",
            "run it again"};
  }
  return {kCourseErrors, file.path + " is there already, so nothing was written",
          "choose another name, or move that file away"};
}

// Undoes what was written, unless all of it was.
class Undo {
 public:
  explicit Undo(const fs::path& root) : root_(root) {}
  ~Undo() {
    std::error_code none;
    for (const NewFile* file : written_) {
      if (!file->before) fs::remove(root_ / file->path, none);
    }
  }
  Undo(const Undo&) = delete;
  Undo& operator=(const Undo&) = delete;

  void add(const NewFile& file) { written_.push_back(&file); }
  void forget() { written_.clear(); }

 private:
  const fs::path& root_;
  std::vector<const NewFile*> written_;
};

}  // namespace

tl::unexpected<Refusal> wrong_words(std::string message, std::string cure) {
  return tl::unexpected(Refusal{kWrongUsage, std::move(message), std::move(cure)});
}

tl::unexpected<Refusal> wrong_course(std::string message, std::string cure) {
  return tl::unexpected(Refusal{kCourseErrors, std::move(message), std::move(cure)});
}

tl::expected<void, Refusal> check_length(const fs::path& path) {
  for (const fs::path& part : path) {
    if (part.native().size() <= kLongestName) continue;
    return wrong_words("`" + part.string() + "` is too long for a name on the disk",
                       "choose a shorter name");
  }
  return {};
}

tl::expected<void, Refusal> write_new_files(const fs::path& root,
                                            const std::vector<NewFile>& files) {
  if (auto good = check_length(root); !good) return good;
  for (const NewFile& file : files) {
    if (auto good = check_length(file.path); !good) return good;
    if (!file.before && fs::exists(fs::symlink_status(root / file.path))) {
      return tl::unexpected(in_the_way(file));
    }
  }
  Undo undo(root);
  for (const NewFile& file : files) {
    try {
      if (!replace_file(root, file.path, file.before, file.bytes)) {
        return tl::unexpected(in_the_way(file));
      }
    } catch (const RefusedPath& refused) {
      return wrong_course(std::string(refused.what()) + ", so nothing was written",
                          "move the link away, or put a folder there");
    }
    undo.add(file);
  }
  undo.forget();
  return {};
}

int tell(const Refusal& refusal) {
  // It may repeat a word of the command line, and that may be an address; and the name of a file,
  // which may be anything.
  std::cerr << "mjcourse: " << readable(without_userinfo(refusal.message)) << '\n';
  if (!refusal.cure.empty()) std::cerr << "  cure: " << readable(refusal.cure) << '\n';
  return refusal.code;
}

void tell(const std::vector<NewFile>& files) {
  for (const NewFile& file : files) {
    std::cout << (file.before ? "added to " : "wrote ") << file.path << '\n';
  }
}

}  // namespace mjcourse
