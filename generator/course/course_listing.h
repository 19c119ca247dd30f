// What course.yaml lists, without reading any lesson, and one more of it in the file's text.
//
// Enter at read_listing; then ask which place a new level or lesson gets, and put it there. Every
// other byte of the file stays. What comes of it is parsed again and compared; nothing comes of it
// where that is not the old course with the one new thing, as in a file whose lists are anchors.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace mjcourse {

struct ListedLevel {
  std::string folder;                // "1-state"
  std::string number;                // "1"; empty for "guide"
  std::vector<std::string> lessons;  // "1.2-generalized-coordinates"
};

// Nothing where `yaml` is no course file whose levels each have a folder.
std::optional<std::vector<ListedLevel>> read_listing(const std::string& yaml);

// The number in front of a level's folder, "" where it has none.
std::string level_number(const std::string& folder);

// `yaml` with a level without lessons: behind those with smaller numbers, or without a number at
// the end.
std::optional<std::string> with_level(const std::string& yaml, const std::string& folder,
                                      const std::string& title);

// `yaml` with the lesson `name` in the level `folder`, ahead of the first with a greater number.
std::optional<std::string> with_lesson(const std::string& yaml, const std::string& folder,
                                       const std::string& name);

}  // namespace mjcourse
