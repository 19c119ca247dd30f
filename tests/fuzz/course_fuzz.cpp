// A whole course: the input is content/course.yaml, a lesson and a glossary, with lines `%%%`
// between them.
#include <vector>

#include "course/course.h"
#include "course/course_listing.h"
#include "diagnostic_check.h"
#include "fuzz.h"
#include "lesson/unloaded_lesson.h"
#include "lesson_check.h"
#include "require.h"

namespace mjcourse {
namespace {

std::vector<std::string> parts_of(const std::string& input) {
  const std::string between = "%%%\n";
  std::vector<std::string> parts;
  std::size_t at = 0;
  for (std::size_t end; parts.size() < 2 && (end = input.find(between, at)) != input.npos;) {
    parts.push_back(input.substr(at, end - at));
    at = end + between.size();
  }
  parts.push_back(input.substr(at));
  return parts;
}

// All bytes of `before`, in their order, with more between them.
bool only_adds(const std::string& before, const std::string& after) {
  auto at = before.begin();
  for (const char c : after) {
    if (at != before.end() && *at == c) ++at;
  }
  return at == before.end();
}

// What `mjcourse new` makes of the course's file.
void check_listing(const std::string& yaml) {
  const auto levels = read_listing(yaml);
  if (!levels) return;
  if (const auto after = with_level(yaml, "2-new", "New: \"one\"")) {
    require(only_adds(yaml, *after), "a new level leaves all that was there");
    require(read_listing(*after).value().size() == levels->size() + 1, "a new level is there");
  }
  for (const ListedLevel& level : *levels) {
    const auto after = with_lesson(yaml, level.folder, "1.5-new");
    require(!after || only_adds(yaml, *after), "a new lesson leaves all that was there");
  }
}

void check_course(const std::string& input) {
  const char* const paths[] = {"content/course.yaml", "content/1-a/1.1-x.md", kGlossaryPath};
  std::map<std::string, std::string> files{{"models/m.xml", "<mujoco/>"}};
  Sources sources;
  const std::vector<std::string> parts = parts_of(input);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    files[paths[i]] = parts[i];
    sources.emplace(paths[i], SourceText(paths[i], parts[i]));
  }
  check_listing(parts[0]);
  Diagnostics diagnostics, again;
  const MemoryFiles memory(files);
  const std::optional<Course> course = read_course(memory, diagnostics);
  check_diagnostics(diagnostics, sources);
  require(course || !diagnostics.empty(), "a course that cannot be read is a mistake");
  const std::optional<Course> second = read_course(memory, again);
  require(text_of(diagnostics) == text_of(again), "a second reading finds the same mistakes");
  if (!course) return;
  for (const Level& level : course->levels) {
    for (const std::size_t lesson : level.lessons) {
      require(lesson < course->lessons.size(), "a level's lesson is there");
    }
  }
  for (const Lesson& lesson : course->lessons) check_lesson(reload(lesson, memory));
  if (course->glossary) check_lesson(course->glossary->page);
}

}  // namespace
}  // namespace mjcourse

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  mjcourse::check_course(mjcourse::text_of_input(data, size));
  return 0;
}
