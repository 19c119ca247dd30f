#include <algorithm>
#include <set>
#include <utility>

#include "course/course.h"
#include "course/former_page.h"
#include "course/language.h"
#include "course/lesson_cache.h"
#include "course/level_folder.h"
#include "course/link_target.h"
#include "course/missing_lesson.h"
#include "course/prerequisites.h"
#include "course/quotation_marks.h"
#include "course/reference_picture.h"
#include "course/web_address.h"
#include "lesson/json/yaml_map.h"
#include "lesson/read_glossary.h"
#include "lesson/read_lesson.h"
#include "lesson/syntax/is_text.h"
#include "lesson/syntax/reading.h"
#include "lesson/unloaded_lesson.h"
#include "report/refused_file.h"

namespace mjcourse {
namespace {

constexpr const char* kId = "E-course-yaml";
constexpr std::size_t kMostLessons = 20'000;
constexpr std::size_t kMostFileNames = 100;  // that are wrong in a folder, and are told

// Tells of the file or folder `path` where it is refused.
void report_refused(const std::string& path, const Files& files, Diagnostics& diagnostics) {
  if (const auto refusal = files.refusal(path)) {
    diagnostics.push_back(refused_file({path, 0, 0, 1, ""}, path, *refusal));
  }
}

// What is used without being named: models and headers, of which a compiler would tell that they
// cannot be opened.
void report_refused_folders(const Files& files, Diagnostics& diagnostics) {
  report_refused("models", files, diagnostics);
  report_refused("examples", files, diagnostics);
  if (files.refusal("examples")) return;
  report_refused("examples/include", files, diagnostics);
  for (const std::string& name : files.list_below("examples/include")) {
    const std::string path = "examples/include/" + name;
    if (!is_too_deep(path)) report_refused(path, files, diagnostics);  // report_names() tells of it
  }
}

// The fault of a file in `models` or `examples`. In the site, others come to lie beside it.
std::optional<NameFault> fault_of_file(const std::string& path) {
  if (auto fault = fault_of_path(path, Hidden::is_allowed)) return fault;
  for (std::size_t begin = 0, end = 0; (end = path.find('/', begin)) != path.npos;
       begin = end + 1) {
    const std::string folder = path.substr(begin, end - begin);
    if (ends_as_a_file(folder)) return NameFault{folder, "ends as a file of the site does"};
  }
  return std::nullopt;
}

// What is wrong with where `path` lies, or with its name.
std::optional<Diagnostic> wrong_place(const std::string& folder, const std::string& path,
                                      const Files& files) {
  const Place place{path, 0, 0, 1, ""};
  if (is_too_deep(path)) {
    const auto refusal = files.refusal(path);
    return refusal ? std::optional(refused_file(place, path, *refusal)) : std::nullopt;
  }
  const auto fault = fault_of_file(path.substr(folder.size() + 1));
  if (!fault) return std::nullopt;
  return error_at(place, "E-file-name",
                  "readers get the files of `" + folder + "/`, and " + fault->text(),
                  "rename it; letters, digits, `-`, `_` and dots are good everywhere");
}

// Readers get what is used of these files, in the site and in archives.
void report_names(const std::string& folder, const Files& files, Diagnostics& diagnostics) {
  std::size_t left = kMostFileNames;
  for (const std::string& name : files.list_below(folder)) {
    auto wrong = wrong_place(folder, folder + "/" + name, files);
    if (!wrong) continue;
    diagnostics.push_back(*std::move(wrong));
    if (--left == 0) return;
  }
}

void report_missing(const std::string& message, const std::string& cure, Diagnostics& diagnostics) {
  diagnostics.push_back(error_at({kCoursePath, 0, 0, 1, ""}, kId, message, cure));
}

// A lesson that course.yaml names, and what came of reading it.
struct Listed {
  std::size_t level;
  LocatedText entry;
  std::string path;
  std::optional<Lesson> lesson = {};
  std::optional<FileRefusal> refusal = {};
  Diagnostics diagnostics = {};
};

// The address that course.yaml has under `key`, "" where it is none.
std::string read_address(YamlMap& map, const std::string& key, const std::string& id,
                         std::optional<AddressFault> (*fault_of)(std::string_view),
                         Reading& reading) {
  const LocatedText address = map.string(key);
  if (address.text.empty()) return "";
  const auto fault = fault_of(address.text);
  if (!fault) return address.text;
  reading.error(id, address.span(fault->begin, fault->end), fault->message, fault->cure);
  return "";
}

// The folder of a level; "" where that is none, which is reported.
std::string read_folder(YamlMap& map, Reading& reading) {
  const LocatedText folder = map.required_string("folder");
  if (folder.text.empty()) return "";
  const auto fault = fault_of_level_folder(folder.text);
  if (!fault) return folder.text;
  reading.error("E-level-folder", folder.span(),
                "a level lies in a folder of `content/`, and " + fault->text(),
                "give the folder one plain name, as `1-first-steps`, and write that here");
  return "";
}

bool is_lesson_name(const LocatedText& entry, Reading& reading) {
  const auto fault = fault_of_name(entry.text);
  if (!fault) return true;
  reading.error(
      "E-lesson-name", entry.span(),
      "a lesson is a file in its level's folder, and " + fault->text(),
      "give the file one plain name, as `1.2-a-title.md`, and write that here without `.md`");
  return false;
}

std::vector<Listed> read_levels(const std::vector<YAML::Node>& nodes, const LocatedText& text,
                                Reading& reading, Course& course) {
  std::vector<Listed> listed;
  std::size_t lessons = 0;
  for (const YAML::Node& node : nodes) {
    YamlMap map(node, "level", kId, text, reading);
    Level level;
    level.folder = read_folder(map, reading);
    level.number = level.folder.substr(0, level.folder.find_first_not_of("0123456789"));
    level.title = map.required_string("title").text;
    for (LocatedText& entry : map.strings("lessons")) {
      if (++lessons > kMostLessons) {
        if (lessons == kMostLessons + 1) {
          reading.error("E-course-size", entry.span(), "a course has at most 20000 lessons",
                        "make several courses of it");
        }
        continue;
      }
      if (level.folder.empty() || !is_lesson_name(entry, reading)) continue;
      std::string path = "content/" + level.folder + "/" + entry.text + ".md";
      listed.push_back({course.levels.size(), std::move(entry), std::move(path)});
    }
    map.finish();
    if (!level.folder.empty()) course.levels.push_back(std::move(level));
  }
  return listed;
}

// On one of several threads.
void read_listed(const Files& files, const Typography& typography, LessonCache* cache,
                 Listed& listed, bool stays_loaded) {
  if (!files.exists(listed.path)) return;
  tl::expected<std::string, std::string> bytes = files.read(listed.path);
  if (!bytes) {
    listed.refusal = files.refusal(listed.path);
    return;
  }
  if (cache != nullptr) listed.lesson = cache->take(listed.path, *bytes, typography);
  if (listed.lesson) return;
  listed.lesson = read_lesson(listed.path, *std::move(bytes), listed.diagnostics, typography);
  if (!listed.lesson || stays_loaded) return;
  // A mistake needs the text around it.
  const bool is_outline = listed.diagnostics.empty() && is_prose(*listed.lesson);
  unload(*listed.lesson, is_outline ? Lesson::Kept::outline : Lesson::Kept::blocks);
}

// Append the lesson to the course, or say why not.
void add_listed(const Files& files, Listed& listed, Reading& reading, Course& course,
                Diagnostics& diagnostics) {
  Level& level = course.levels[listed.level];
  const Span span = listed.entry.span();
  diagnostics.insert(diagnostics.end(), listed.diagnostics.begin(), listed.diagnostics.end());
  if (listed.refusal) {
    diagnostics.push_back(
        refused_file(place_of(reading.source(), span), listed.path, *listed.refusal));
  } else if (!listed.lesson && listed.diagnostics.empty()) {
    const MissingLesson missing = missing_lesson(files, level.folder, listed.entry.text);
    reading.error("E-lesson-missing", span, missing.message, missing.cure);
  } else if (listed.lesson && course.find_lesson(listed.lesson->number) != nullptr) {
    reading.error("E-lesson-number", span,
                  "the number " + listed.lesson->number + " is taken by a lesson above",
                  "number each lesson once");
  } else if (listed.lesson) {
    level.lessons.push_back(course.lessons.size());
    course.add(*std::move(listed.lesson));
  }
}

// A lesson that nothing lists is checked by nobody, and looks as if it were. Where course.yaml has
// a mistake, that may be why, and is said instead.
void warn_of_unlisted(const Files& files, const Course& course, Diagnostics& diagnostics) {
  std::set<std::string> spoken_of;
  for (const Diagnostic& diagnostic : diagnostics) spoken_of.insert(diagnostic.place.file);
  for (const Lesson& lesson : course.lessons) spoken_of.insert(lesson.source->path());
  if (spoken_of.contains(kCoursePath)) return;
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

// Where there is a file and it cannot be read, that is said; which terms it has is then unknown.
void read_glossary_file(const Files& files, Course& course, Diagnostics& diagnostics) {
  const tl::expected<std::string, std::string> bytes = files.read(kGlossaryPath);
  if (bytes) course.glossary = read_glossary(*bytes, diagnostics, course.typography);
  report_refused(kGlossaryPath, files, diagnostics);
  if (!bytes && files.exists(kGlossaryPath) && !files.refusal(kGlossaryPath)) {
    diagnostics.push_back(error_at({kGlossaryPath, 0, 0, 1, ""}, "E-file-refused",
                                   "cannot read " + bytes.error(), "make it readable"));
  }
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

struct DeadReference {
  DeadLink dead;
  Span span;
};

std::vector<DeadReference> dead_references(const Course& course, const FormerPages& former,
                                           const Lesson& lesson) {
  std::vector<DeadReference> found;
  for (const Link& link : lesson.links) {
    auto target = resolve_link(course, lesson, link.target.text);
    if (target) continue;
    if (link.in_angle_brackets) {  // of a type, mostly: `std::vector<std::string>`
      const std::string written = "<" + link.target.text + ">";
      target.error().cure = "what stands in `<…>` is a link; as text, write it as code, `` `" +
                            written + "` ``, or `\\" + written + "`";
    }
    found.push_back({target.error(), link.target.span()});
  }
  for (const LocatedText& number : lesson.front.prerequisites) {
    const auto dead = dead_lesson(course, lesson, number.text);
    if (dead) found.push_back({*dead, number.span()});
  }
  for (std::size_t i = 0; i < lesson.front.formerly.size(); ++i) {
    const auto fault = former.fault(lesson, i);
    if (fault) found.push_back({*fault, lesson.front.formerly[i].span()});
  }
  return found;
}

void check_references(const Files& files, Course& course, Diagnostics& diagnostics) {
  const FormerPages former(course);
  const auto check = [&](Lesson& lesson) {
    const std::vector<DeadReference> found = dead_references(course, former, lesson);
    if (found.empty()) return;
    if (lesson.kept == Lesson::Kept::outline) {
      lesson = reload(lesson, files);
      unload(lesson, Lesson::Kept::blocks);
    }
    Reading reading(*lesson.source, diagnostics);
    for (const auto& [dead, span] : found) reading.error(dead.id, span, dead.message, dead.cure);
  };
  for (Lesson& lesson : course.lessons) check(lesson);
  if (course.glossary) check(course.glossary->page);
}

}  // namespace

const Lesson* Course::find_lesson(const std::string& number) const {
  const auto found = by_number_.find(number);
  return found == by_number_.end() ? nullptr : &lessons[found->second];
}

void Course::add(Lesson lesson) {
  lesson.index = lessons.size();
  by_number_.try_emplace(lesson.number, lessons.size());
  lessons.push_back(std::move(lesson));
}

std::vector<const Lesson*> Course::pages() const {
  std::vector<const Lesson*> pages;
  for (const Lesson& lesson : lessons) pages.push_back(&lesson);
  if (glossary) pages.push_back(&glossary->page);
  return pages;
}

std::optional<Course> read_course(const Files& files, Diagnostics& diagnostics, std::size_t threads,
                                  std::size_t most_loaded, LessonCache* cache) {
  const tl::expected<std::string, std::string> bytes = files.read(kCoursePath);
  if (!bytes && files.refusal(kCoursePath)) {
    report_refused(kCoursePath, files, diagnostics);
    return std::nullopt;
  }
  if (!bytes) {
    report_missing("cannot read " + bytes.error(),
                   "a course is a folder with content/course.yaml; name it with --course DIR",
                   diagnostics);
    return std::nullopt;
  }
  if (!is_text(kCoursePath, *bytes, diagnostics)) return std::nullopt;
  const SourceText source(kCoursePath, *bytes);
  Reading reading(source, diagnostics);
  const LocatedText text = located(source, {0, source.text().size()});
  const std::optional<YAML::Node> yaml = parse_yaml(text, "course file", kId, reading);
  if (!yaml) return std::nullopt;

  Course course;
  YamlMap map(*yaml, "course file", kId, text, reading);
  course.title = map.required_string("title").text;
  course.description = map.string("description").text;
  if (const LocatedText language = map.string("language"); !language.text.empty()) {
    const auto cure = cure_of_language(language.text);
    if (cure) {
      reading.error("E-course-language", language.span(),
                    "`" + language.text + "` is not a language tag", *cure);
    } else {
      course.language = language.text;
    }
  }
  course.typography = {map.boolean("smart-punctuation", true), quotation_marks(course.language)};
  course.macros = map.texts("macros");
  course.url = read_address(map, "url", "E-course-url", site_address_fault, reading);
  if (!course.url.empty()) course.url = site_root(course.url);
  course.edit = read_address(map, "edit", "E-course-edit", edit_address_fault, reading);
  std::vector<Listed> listed = read_levels(map.required_items("levels"), text, reading, course);
  map.finish();
  for_each_index(listed.size(), threads, [&](std::size_t index, std::size_t) {
    read_listed(files, course.typography, cache, listed[index], index < most_loaded);
  });
  course.lessons.reserve(listed.size());
  for (Listed& one : listed) add_listed(files, one, reading, course, diagnostics);
  course.models = model_names(files);
  report_refused_folders(files, diagnostics);
  report_names("models", files, diagnostics);
  report_names("examples", files, diagnostics);
  warn_of_unlisted(files, course, diagnostics);
  read_glossary_file(files, course, diagnostics);
  check_references(files, course, diagnostics);
  check_terms(files, course, diagnostics);
  warn_of_missing_prerequisites(course, diagnostics);
  for (Lesson& lesson : course.lessons) forget_links(lesson);
  warn_of_unused_references(files, course, diagnostics);
  return course;
}

std::vector<std::string> model_names(const Files& files) {
  std::vector<std::string> names;
  for (const std::string& name : files.list_below("models")) {
    if (!name.ends_with(".xml") || fault_of_path(name, Hidden::is_allowed)) continue;
    names.push_back(name.substr(0, name.size() - 4));
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace mjcourse
