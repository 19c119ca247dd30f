#include "toolchain/course_headers.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/content_hash.h"
#include "base/files.h"

namespace mjcourse {

namespace fs = std::filesystem;
using nlohmann::json;

CourseHeaders::CourseHeaders(const IncludeFolders& folders) {
  for (const fs::path& folder : folders) {
    folders_.push_back(fs::absolute(folder).lexically_normal());
    shown_.emplace_back("/mjcourse/include-" + std::to_string(shown_.size()));
  }
}

std::string CourseHeaders::true_path(const std::string& path) const {
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    const std::string& shown = shown_[i].native();
    if (path.starts_with(shown + "/")) return folders_[i].native() + path.substr(shown.size());
  }
  return path;
}

std::string CourseHeaders::overlay(const std::optional<fs::path>& source) const {
  json roots = json::array();
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    roots.push_back({{"type", "directory-remap"},
                     {"name", shown_[i].string()},
                     {"external-contents", folders_[i].string()}});
  }
  if (source) {
    roots.push_back({{"type", "file"}, {"name", kSource}, {"external-contents", source->string()}});
  }
  return json{{"version", 0}, {"use-external-names", false}, {"roots", std::move(roots)}}.dump();
}

std::string CourseHeaders::contents() const {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < folders_.size(); ++i) {
    std::error_code none;
    for (const fs::directory_entry& file : fs::recursive_directory_iterator(folders_[i], none)) {
      if (!file.is_regular_file(none)) continue;
      const std::string name = file.path().lexically_relative(folders_[i]).string();
      const auto bytes = read_file(folders_[i] / name);
      lines.push_back(std::to_string(i) + "/" + name + " " +
                      (bytes ? content_hash(*bytes) : "unreadable") + "\n");
    }
  }
  std::sort(lines.begin(), lines.end());
  std::string text;
  for (const std::string& line : lines) text += line;
  return text;
}

}  // namespace mjcourse
