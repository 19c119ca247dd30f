// course.yaml for those who add to it: its text, what it lists, and the text with more in it.
// Tested by tests/generator/cli/new_part_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "base/files.h"
#include "cli/new_files.h"
#include "course/course.h"
#include "course/course_listing.h"

namespace mjcourse {

// `why` the file cannot be read.
Refusal no_course(const std::string& why);

struct CourseFile {
  std::string yaml;
  std::vector<ListedLevel> levels;

  // Null where there is none; `name` is its folder, or its number.
  const ListedLevel* find_level(const std::string& name) const;
  // "1-state", "guide"
  std::vector<std::string> folders() const;
};

tl::expected<CourseFile, Refusal> read_course_file(const Files& course);

// The file to write; `edited` is the text with `what` in it, or nothing where that was not safe,
// and `line` is what its author is to write instead.
tl::expected<NewFile, Refusal> edited_course_file(const CourseFile& file,
                                                  std::optional<std::string> edited,
                                                  const std::string& what, const std::string& line);

// A title is one line of text.
tl::expected<void, Refusal> check_title(const std::string& title);

}  // namespace mjcourse
