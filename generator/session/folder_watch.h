// FolderWatch: what changes in some folders, with all below them, told once for each save.
//
// Editors save in many ways: they write the file, or write another and rename it, or move the old
// one away first; a checkout changes hundreds of files. Whatever comes within a few milliseconds is
// one change. What a link leads to is watched as well, where that lies beside the folders, and told
// under the link's name. A file that is gone gets a moment longer to come back.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

namespace mjcourse {

// All that a course's truth is made of lies in these folders of its own.
inline constexpr std::array kCourseFolders{"content", "models", "examples", "theme"};

class FolderWatch {
 public:
  // Folders that are not there yet are watched from when they come, if their parents are there.
  // Throws std::system_error where the kernel has no more watches to give.
  explicit FolderWatch(const std::vector<std::filesystem::path>& folders);
  ~FolderWatch();
  FolderWatch(const FolderWatch&) = delete;
  FolderWatch& operator=(const FolderWatch&) = delete;

  // Waits for a change, and gives the files and folders that it touched; none once `stop` is
  // requested. Where the kernel lost count, all folders.
  std::set<std::filesystem::path> wait(const std::stop_token& stop);

 private:
  bool is_ours(const std::filesystem::path& path) const;
  void watch(const std::filesystem::path& folder);
  void watch_below(const std::filesystem::path& folder);
  void forget_below(const std::filesystem::path& folder);
  void watch_all();
  bool poll_for(int milliseconds, const std::stop_token& stop) const;
  void read_events();
  // Where `link` leads to, as long as that is in the course.
  void watch_target(const std::filesystem::path& link);
  void add(const std::filesystem::path& path);
  void take(unsigned mask, const std::filesystem::path& path);

  std::vector<std::filesystem::path> folders_;
  int notify_;
  std::map<std::filesystem::path, std::filesystem::path> targets_;  // by the links to them
  std::map<int, std::filesystem::path> watched_;                    // by the kernel's number
  std::set<std::filesystem::path> changed_, gone_;
};

}  // namespace mjcourse
