#include <algorithm>
#include <set>
#include <utility>

#include "base/nearest.h"
#include "course/course.h"
#include "course/link_target.h"
#include "course/reference_picture.h"
#include "lesson/is_utf8.h"
#include "lesson/read_glossary.h"
#include "lesson/read_lesson.h"
#include "lesson/reading.h"
#include "lesson/yaml_map.h"

namespace mjcourse {
namespace {

constexpr const char* kPath = "content/course.yaml";
constexpr const char* kId = "E-course-yaml";

void report_missing(const std::string& message, const std::string& cure, Diagnostics& diagnostics) {
  diagnostics.push_back(error_at({kPath, 0, 0, 1, ""}, kId, message, cure));
}

// The lesson that course.yaml names as `entry` in `folder`, appended to the course.
void read_listed_lesson(const Files& files, Level& level, const LocatedText& entry,
                        Reading& reading, Course& course, Diagnostics& diagnostics) {
  const std::string folder = "content/" + level.folder;
  const std::string path = folder + "/" + entry.text + ".md";
  if (!files.exists(path)) {
    std::vector<std::string> there;
    for (const std::string& name : files.list(folder)) {
      if (name.ends_with(".md")) there.push_back(name.substr(0, name.size() - 3));
    }
    reading.error("E-lesson-missing", entry.span(), "there is no file " + path,
                  suggest(entry.text, there));
    return;
  }
  const tl::expected<std::string, std::string> bytes = files.read(path);
  if (!bytes) {
    reading.error("E-lesson-missing", entry.span(), "cannot read " + bytes.error());
    return;
  }
  std::optional<Lesson> lesson = read_lesson(path, *bytes, diagnostics);
  if (!lesson) return;
  if (course.find_lesson(lesson->number) != nullptr) {
    reading.error("E-lesson-number", entry.span(),
                  "the number " + lesson->number + " is taken by a lesson above",
                  "number each lesson once");
    return;
  }
  level.lessons.push_back(course.lessons.size());
  course.lessons.push_back(std::move(*lesson));
}

void read_level(const Files& files, const YAML::Node& node, const LocatedText& text,
                Reading& reading, Course& course, Diagnostics& diagnostics) {
  YamlMap map(node, "level", kId, text, reading);
  Level level;
  level.folder = map.required_string("folder").text;
  level.number = level.folder.substr(0, level.folder.find_first_not_of("0123456789"));
  level.title = map.required_string("title").text;
  for (const LocatedText& entry : map.strings("lessons")) {
    read_listed_lesson(files, level, entry, reading, course, diagnostics);
  }
  map.finish();
  course.levels.push_back(std::move(level));
}

// A lesson that nothing lists is checked by nobody, and looks as if it were. Where course.yaml has
// a mistake, that may be why, and is said instead.
void warn_of_unlisted(const Files& files, const Course& course, Diagnostics& diagnostics) {
  std::set<std::string> spoken_of;
  for (const Diagnostic& diagnostic : diagnostics) spoken_of.insert(diagnostic.place.file);
  for (const Lesson& lesson : course.lessons) spoken_of.insert(lesson.source->path());
  if (spoken_of.contains(kPath)) return;
  for (const Level& level : course.levels) {
    for (const std::string& name : files.list("content/" + level.folder)) {
      const std::string path = "content/" + level.folder + "/" + name;
      if (!name.ends_with(".md") || spoken_of.contains(path)) continue;
      Diagnostic unlisted =
          error_at({path, 0, 0, 1, ""}, "W-lesson-unlisted",
                   "course.yaml does not list this lesson, so it is not checked",
                   "add it to the `lessons` of its level; `draft: true` keeps it out of the site");
      unlisted.severity = Severity::warning;
      diagnostics.push_back(std::move(unlisted));
    }
  }
}

// Where there is a file and it cannot be read, that was said; which terms it has is then unknown.
void read_glossary_file(const Files& files, Course& course, Diagnostics& diagnostics) {
  const tl::expected<std::string, std::string> bytes = files.read(kGlossaryPath);
  if (bytes) course.glossary = read_glossary(*bytes, diagnostics);
}

void check_terms(const Files& files, const Course& course, Diagnostics& diagnostics) {
  if (!course.glossary && files.exists(kGlossaryPath)) return;
  for (const Lesson* page : course.pages()) {
    Reading reading(*page->source, diagnostics);
    for (const Block& block : page->blocks) {
      const auto* term = std::get_if<TermUse>(&block);
      if (term == nullptr) continue;
      if (const auto dead = unknown_term(course, *term)) {
        reading.error(dead->id, term->name.span(), dead->message, dead->cure);
      }
    }
  }
}

void check_references(const Course& course, Diagnostics& diagnostics) {
  for (const Lesson* page : course.pages()) {
    const Lesson& lesson = *page;
    Reading reading(*lesson.source, diagnostics);
    for (const Link& link : lesson.links) {
      const auto target = resolve_link(course, lesson, link.target.text);
      if (target) continue;
      reading.error(target.error().id, link.target.span(), target.error().message,
                    target.error().cure);
    }
    for (const LocatedText& number : lesson.front.prerequisites) {
      const auto dead = dead_lesson(course, lesson, number.text);
      if (dead) reading.error(dead->id, number.span(), dead->message, dead->cure);
    }
  }
}

}  // namespace

const Lesson* Course::find_lesson(const std::string& number) const {
  const auto found = std::find_if(lessons.begin(), lessons.end(),
                                  [&](const Lesson& lesson) { return lesson.number == number; });
  return found == lessons.end() ? nullptr : &*found;
}

std::vector<const Lesson*> Course::pages() const {
  std::vector<const Lesson*> pages;
  for (const Lesson& lesson : lessons) pages.push_back(&lesson);
  if (glossary) pages.push_back(&glossary->page);
  return pages;
}

std::optional<Course> read_course(const Files& files, Diagnostics& diagnostics) {
  const tl::expected<std::string, std::string> bytes = files.read(kPath);
  if (!bytes) {
    report_missing("cannot read " + bytes.error(),
                   "a course is a folder with content/course.yaml; name it with --course DIR",
                   diagnostics);
    return std::nullopt;
  }
  if (!is_utf8(kPath, *bytes, diagnostics)) return std::nullopt;
  const SourceText source(kPath, *bytes);
  Reading reading(source, diagnostics);
  const LocatedText text = located(source, {0, source.text().size()});
  const std::optional<YAML::Node> yaml = parse_yaml(text, "course file", kId, reading);
  if (!yaml) return std::nullopt;

  Course course;
  YamlMap map(*yaml, "course file", kId, text, reading);
  course.title = map.required_string("title").text;
  course.description = map.string("description").text;
  if (const LocatedText language = map.string("language"); !language.text.empty()) {
    course.language = language.text;
  }
  course.macros = map.texts("macros");
  for (const YAML::Node& level : map.required_items("levels")) {
    read_level(files, level, text, reading, course, diagnostics);
  }
  map.finish();
  for (const std::string& name : files.list("models")) {
    if (name.ends_with(".xml")) course.models.push_back(name.substr(0, name.size() - 4));
  }
  warn_of_unlisted(files, course, diagnostics);
  read_glossary_file(files, course, diagnostics);
  check_references(course, diagnostics);
  check_terms(files, course, diagnostics);
  warn_of_unused_references(files, course, diagnostics);
  return course;
}

}  // namespace mjcourse
