// Course: course.yaml and the lessons it lists, with every reference between them resolved.
//
// Enter at read_course. The generator knows nothing of any one course: titles, levels, order,
// models and macros all come from the course's folder.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/files.h"
#include "base/parallel.h"
#include "lesson/blocks/lesson.h"
#include "lesson/glossary.h"
#include "report/diagnostic.h"

namespace mjcourse {

class LessonCache;

// Where a course begins.
inline constexpr const char* kCoursePath = "content/course.yaml";

struct Level {
  std::string folder, title;
  std::string number;  // "1" of "1-state"; empty for what stands beside the course, as "guide"
  std::vector<std::size_t> lessons;  // indices into Course::lessons, in the course's order
};

struct Course {
  std::string title, description, language = "en";
  Typography typography;  // of all its pages
  std::string url;   // where the site is published: "https://example.org/course/"; "" unless told
  std::string edit;  // where a lesson is edited, with {path} for its file; "" unless told
  std::map<std::string, std::string> macros;  // TeX, shared by all lessons: "\\R" → "\\mathbb{R}"
  std::vector<Level> levels;
  std::vector<Lesson> lessons;  // in the course's order; most of many are unloaded
  // Names: "joint_zoo" for models/joint_zoo.xml, "arm/scene" for models/arm/scene.xml, made of
  // plain names (base/plain_name.h). A file that only others include is among them, and nobody
  // compiles it by itself.
  std::vector<std::string> models;
  std::optional<Glossary> glossary;

  // Null where there is none. Of lessons with the same number, the first.
  const Lesson* find_lesson(const std::string& number) const;
  void add(Lesson lesson);
  // All that is read like a lesson: the lessons, and the glossary's page where there is one.
  std::vector<const Lesson*> pages() const;

 private:
  std::unordered_map<std::string, std::size_t> by_number_;  // of the lessons
};

// A loaded lesson takes some 180 KB for 12 KB of text. To reload one is to read it again.
inline constexpr std::size_t kMostLoaded = 500;

// Read content/course.yaml and every lesson in it, on so many threads, and check the links between
// them; after the first `most_loaded` lessons, the others are unloaded (lesson/unloaded_lesson.h).
// Lessons that are in `cache` are taken from it instead.
// Mistakes go to `diagnostics`; nothing is returned only when there is no readable course.yaml.
std::optional<Course> read_course(const Files& files, Diagnostics& diagnostics,
                                  std::size_t threads = core_count(),
                                  std::size_t most_loaded = kMostLoaded,
                                  LessonCache* cache = nullptr);

// What Course::models has, sorted.
std::vector<std::string> model_names(const Files& files);

}  // namespace mjcourse
