#include "page/foreign_files.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <set>
#include <sstream>
#include <system_error>
#include <utility>

#include "base/files.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

// Of a list. A site of twenty thousand lessons has one of some megabytes.
constexpr std::uintmax_t kMostList = 64 << 20;  // bytes
// Folders of a site in each other: a course may have a hundred.
constexpr std::size_t kMostDepth = 200;

bool is_own_folder(const fs::path& path) {
  return fs::is_directory(fs::symlink_status(path));  // and no link to one
}
// The same of an entry, whose kind a listing mostly has with it.
bool is_own_folder(const fs::directory_entry& entry) {
  return !entry.is_symlink() && entry.is_directory();
}

// A list may be a stranger's, and what it has is removed: no build has written a `.git` or a
// `CNAME`. Deeper, a build may have hidden files: those of a hidden model.
bool can_be_a_builds(const fs::path& path) {
  return path.has_extension() && !path.native().starts_with('.');
}

Names listed_files(const fs::path& site) {
  std::istringstream lines(read_file(site / kSiteList).value_or(""));
  Names names{kSiteList};
  for (std::string line; std::getline(lines, line);) {
    if (can_be_a_builds(line)) names.insert(line);
  }
  return names;
}

bool holds_some(const std::string& folder, const Names& names) {
  const auto first = names.lower_bound(folder + "/");
  return first != names.end() && first->starts_with(folder + "/");
}

// Looks for what is foreign in `site`, folder by folder.
class ForeignSearch {
 public:
  ForeignSearch(const fs::path& site, const fs::path& other)
      : site_(site), other_(other), listed_(listed_files(site)) {}

  std::vector<std::string> found() {
    to_look_in_.push_back({});
    while (!to_look_in_.empty()) {
      const Folder folder = std::move(to_look_in_.back());
      to_look_in_.pop_back();
      look_in(folder);
    }
    std::ranges::sort(found_);
    return std::move(found_);
  }

 private:
  struct Folder {
    std::string path;
    std::size_t depth = 0;
  };

  void look_in(const Folder& folder) {
    if (folder.depth > kMostDepth) {
      throw FolderRefused((site_ / folder.path).string() + " lies in more than " +
                              std::to_string(kMostDepth) + " folders of the site",
                          "remove it, or name an empty or a new folder");
    }
    for (const auto& entry : fs::directory_iterator(site_ / folder.path)) {
      const std::string name = entry.path().filename().string();
      const std::string path = folder.path.empty() ? name : folder.path + "/" + name;
      const bool is_folder = is_own_folder(entry);
      if (is_folder && (holds_some(path, listed_) || is_own_folder(other_ / path))) {
        to_look_in_.push_back({path, folder.depth + 1});
      } else if (is_folder || !listed_.contains(path)) {
        check_place(path);
        found_.push_back(path);
      }
    }
  }

  // Neither it nor one of the folders above it may be something else in the other site.
  void check_place(const std::string& path) const {
    for (fs::path above = path; !above.empty(); above = above.parent_path()) {
      const auto status = fs::symlink_status(other_ / above);
      if (!fs::exists(status) || (above != path && fs::is_directory(status))) continue;
      const std::string kind = fs::is_directory(status) ? "folder" : "file";
      throw FolderRefused(
          "no build wrote " + (site_ / path).string() + ", so it stays; but the new site has " +
              (above == path ? "a " + kind + " of that name" : "the file " + above.string()),
          "move yours elsewhere, or give it another name");
    }
  }

  const fs::path &site_, &other_;
  const Names listed_;
  std::vector<Folder> to_look_in_;
  std::vector<std::string> found_;
};

// A folder that moves is written to, as it has the folder above it in it.
void refuse_closed(const fs::path& folder) {
  if (eaccess(folder.c_str(), W_OK | X_OK) == 0) return;
  throw FolderRefused(folder.string() + " is in the way of a new site, and cannot be moved: " +
                          std::generic_category().message(errno),
                      "allow this user to write to it, or name an empty or a new folder");
}

}  // namespace

void write_site_list(const OutFolder& site) {
  Names names{kSiteList};
  for (const auto& entry : fs::recursive_directory_iterator(site.path())) {
    if (!is_own_folder(entry.path())) {
      names.insert(entry.path().lexically_relative(site.path()).generic_string());
    }
  }
  std::string lines;
  for (const std::string& name : names) lines += name + "\n";
  site.write(kSiteList, lines);
}

bool has_site_list(const fs::path& site) {
  std::error_code none;
  if (!is_own_folder(site) || !fs::is_regular_file(fs::symlink_status(site / kSiteList))) {
    return false;
  }
  const std::uintmax_t size = fs::file_size(site / kSiteList, none);
  return size > 0 && size <= kMostList;
}

std::vector<std::string> foreign_files(const fs::path& site, const fs::path& other) {
  return ForeignSearch(site, other).found();
}

std::vector<std::string> foreign_files(const fs::path& site) {
  return foreign_files(site, site / kSiteList);  // a file, so nothing is in there, and in the way
}

void refuse_unmovable_files(const fs::path& site) {
  if (!has_site_list(site)) return;
  fs::path checked;  // neighbours lie in one folder
  for (const std::string& path : foreign_files(site)) {
    const fs::path file = site / path;
    if (is_own_folder(file)) refuse_closed(file);
    if (checked != file.parent_path()) refuse_closed(checked = file.parent_path());
  }
}

void move_foreign_files(const OutFolder& site, const OutFolder& other) {
  std::vector<std::string> moved;
  try {
    for (const std::string& path : foreign_files(site.path(), other.path())) {
      site.move(path, other);
      moved.push_back(path);
    }
  } catch (...) {
    for (const std::string& path : moved) other.move(path, site);
    throw;
  }
}

}  // namespace mjcourse
