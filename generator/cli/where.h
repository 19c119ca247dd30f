// WHERE of the command line: a lesson, or the block at one of its lines.
#pragma once

#include <filesystem>
#include <string>
#include <tl/expected.hpp>

#include "course/course.h"
#include "report/diagnostic.h"

namespace mjcourse {

// Lines `first` to `last` of a lesson; all of it where they are 0.
struct Where {
  const Lesson* lesson;
  int line = 0;             // as it was asked for
  int first = 0, last = 0;  // of the fence around it, or the line itself

  bool has(const Place& place) const;
};

// "1.2", "1.2-a-title", "content/1-state/1.2-a-title.md", each also with ":210" behind it; else why
// that is no place of the course, whose folder is `root`.
tl::expected<Where, std::string> find_place(const Course& course, const std::filesystem::path& root,
                                            const std::string& text);

}  // namespace mjcourse
