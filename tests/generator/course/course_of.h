// Reads courses from memory, and shows their mistakes as a terminal would.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "course/course.h"
#include "reading_of.h"

namespace mjcourse {

// A course in memory, and what reading it found.
struct CourseOf {
  using FileMap = std::map<std::string, std::string>;
  explicit CourseOf(FileMap files)
      : course(read_course(MemoryFiles(std::move(files)), diagnostics, core_count(), 0)) {}

  std::string mistakes() const { return shown(diagnostics); }

  Diagnostics diagnostics;
  std::optional<Course> course;
};

inline std::string lesson(const std::string& body, const std::string& front = "") {
  return "---\ntitle: T\n" + front + "---\n" + body;
}

inline const std::string kTwo = R"(title: C
levels:
  - folder: 1-a
    title: First
    lessons: [1.1-x, 1.2-y]
)";

// A course of two lessons with these bodies; the first has `front` in its front matter.
inline CourseOf course_of(const std::string& x, const std::string& y,
                          const std::string& front = "") {
  return CourseOf({{"content/course.yaml", kTwo},
                   {"content/1-a/1.1-x.md", lesson(x, front)},
                   {"content/1-a/1.2-y.md", lesson(y)}});
}

}  // namespace mjcourse
