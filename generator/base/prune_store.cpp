#include "base/prune_store.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>

#include "base/descriptor.h"
#include "base/folder_names.h"
#include "base/folder_size.h"
#include "base/last_use.h"
#include "base/remove_folder.h"
#include "base/store_entry.h"
#include "base/store_layout.h"
#include "base/utf8.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPrepared = "prepared";

struct Entry {
  StorePlace place;  // of what is prepared, without letters
  std::uintmax_t bytes = 0;
  LastUse used;

  bool is_prepared() const { return place.letters.empty(); }
  void count_in(Pruned::Count& count) const {
    ++(is_prepared() ? count.prepared : count.results);
    count.bytes += bytes;
  }
};

class Pruning {
 public:
  explicit Pruning(const fs::path& folder)
      : folder_(folder), root_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (!root_.is_open()) throw_errno(folder);
  }

  // Nobody writes while the store is locked, so all that is here was left behind.
  void clear_unfinished() {
    const Descriptor tmp = opened(root_.get(), "tmp", "tmp");
    if (!tmp.is_open()) return;
    for (const std::string& name : names_in_folder(tmp.get())) {
      const fs::path path = fs::path("tmp") / name;
      if (is_unfinished(tmp.get(), name)) {
        remove(tmp.get(), name, path);
      } else {
        foreign_.add(path);
      }
    }
  }

  void find_entries() {
    for (const char* const kind : {"ac", "cas"}) find_results(kind);
    const Descriptor prepared = opened(root_.get(), kPrepared, kPrepared);
    if (!prepared.is_open()) return;
    for (const std::string& name : names_in_folder(prepared.get())) {
      FolderSize size;
      add_size((prepared_folder(folder_) / name).string(), UINT64_MAX, size);
      entries_.push_back({{kPrepared, "", name}, size.bytes, use_of_prepared(prepared, name)});
    }
  }

  Pruned forget(std::uintmax_t keep) {
    std::ranges::sort(entries_, [](const Entry& a, const Entry& b) {
      return std::tie(a.used, a.place.kind, a.place.letters, a.place.file) <
             std::tie(b.used, b.place.kind, b.place.letters, b.place.file);
    });
    Pruned pruned;
    std::uintmax_t bytes = 0;
    for (const Entry& entry : entries_) bytes += entry.bytes;
    for (const Entry& entry : entries_) {
      const bool goes = bytes > keep && forget(entry.place);
      if (goes) bytes -= entry.bytes;
      entry.count_in(goes ? pruned.removed : pruned.left);
    }
    pruned.notes = notes();
    return pruned;
  }

 private:
  // The first of a kind, for the user, and why.
  struct Finding {
    std::string path, reason;
    std::uintmax_t count = 0;

    void add(const fs::path& at, const std::string& why = "") {
      if (count++ == 0) std::tie(path, reason) = std::pair(at.string(), why);
    }
  };

  std::vector<std::string> notes() const {
    std::vector<std::string> notes;
    const auto add = [&](const Finding& finding, const std::string& before,
                         const std::string& after) {
      if (finding.count == 0) return;
      const std::string more =
          finding.count == 1 ? "" : " and " + std::to_string(finding.count - 1) + " more";
      notes.push_back(before + readable((folder_ / finding.path).string()) + more + after);
    };
    add(foreign_, "no store has written ", ", so it stays; remove it where it is nobody's");
    add(in_place_, "what lay where a result belongs was none, and is removed: ", "");
    add(kept_, "the store cannot remove or read ",
        ": " + kept_.reason + "; ask its owner to remove it");
    return notes;
  }

  // A folder of the store's; what is there instead goes.
  Descriptor opened(int above, const std::string& name, const fs::path& path) {
    Descriptor folder = open_store_folder(above, name);
    if (folder.is_open() || errno == ENOENT) return folder;
    if (errno == ENOTDIR || errno == ELOOP) {
      remove(above, name, path);
    } else {
      kept_.add(path, std::generic_category().message(errno));
    }
    return folder;
  }

  bool remove(int above, const std::string& name, const fs::path& path) {
    const std::error_code failure = remove_folder(above, name);
    if (failure) kept_.add(path, failure.message());
    return !failure;
  }

  // As mkostemp() has named it.
  static bool is_unfinished(int tmp, const std::string& name) {
    struct stat status {};
    return name.size() == std::string_view("XXXXXX").size() &&
           fstatat(tmp, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 && S_ISREG(status.st_mode);
  }

  void find_results(const std::string& kind) {
    const Descriptor above = opened(root_.get(), kind, kind);
    if (!above.is_open()) return;
    for (const std::string& letters : names_in_folder(above.get())) {
      const fs::path path = fs::path(kind) / letters;
      if (!is_letters(letters)) {
        foreign_.add(path);
        continue;
      }
      const Descriptor folder = opened(above.get(), letters, path);
      if (!folder.is_open()) continue;
      for (std::string& name : names_in_folder(folder.get())) {
        add_result(folder.get(), {kind, letters, std::move(name)});
      }
    }
  }

  void add_result(int folder, StorePlace place) {
    const fs::path path = place.in("");
    struct stat file {};
    if (!is_store_name(place.kind + "/" + place.letters + place.file)) {
      foreign_.add(path);
    } else if (fstatat(folder, place.file.c_str(), &file, AT_SYMLINK_NOFOLLOW) != 0) {
      if (errno != ENOENT) kept_.add(path, std::generic_category().message(errno));
    } else if (S_ISREG(file.st_mode) && std::cmp_less_equal(file.st_size, kMostEntryBytes)) {
      const auto bytes = static_cast<std::uintmax_t>(file.st_size);
      entries_.push_back({std::move(place), bytes, LastUse::of(file)});
    } else if (remove(folder, place.file, path)) {
      in_place_.add(path);
    }
  }

  static LastUse use_of_prepared(const Descriptor& prepared, const std::string& name) {
    struct stat file {};
    const std::string current = name + "/current";
    if (fstatat(prepared.get(), current.c_str(), &file, AT_SYMLINK_NOFOLLOW) != 0) return {};
    return LastUse::of(file);
  }

  bool forget(const StorePlace& place) {
    const fs::path path = place.in("");
    Descriptor folder = opened(root_.get(), place.kind, path);
    if (folder.is_open() && !place.letters.empty()) {
      folder = opened(folder.get(), place.letters, path);
    }
    return folder.is_open() && remove(folder.get(), place.file, path);
  }

  const fs::path& folder_;
  Descriptor root_;
  std::vector<Entry> entries_;
  Finding foreign_, in_place_, kept_;
};

}  // namespace

std::optional<Pruned> prune_store(const fs::path& folder, std::uintmax_t keep,
                                  const LockWait& wait) {
  if (!fs::exists(folder)) return Pruned{};
  refuse_other_folder(folder);
  const Descriptor lock = open_store_lock(folder);
  if (!lock.is_open()) throw_errno(folder / "lock");
  if (!take_lock(lock.get(), LOCK_EX, folder / "lock", wait)) return std::nullopt;
  Pruning pruning(folder);
  pruning.clear_unfinished();
  pruning.find_entries();
  return pruning.forget(keep);
}

}  // namespace mjcourse
