#include "lesson/read_lesson.h"

#include <re2/re2.h>

#include <string_view>
#include <utility>

#include "lesson/blocks/lesson_reader.h"
#include "lesson/front_matter.h"
#include "lesson/syntax/is_text.h"

namespace mjcourse {

std::shared_ptr<const SourceText> read_source(const std::string& path, std::string bytes,
                                              Diagnostics& diagnostics) {
  if (!is_text(path, bytes, diagnostics)) return nullptr;
  return std::make_shared<SourceText>(path, std::move(bytes));
}

std::string without_front_matter(const SourceText& source, Span front) {
  const int closing = source.position(front.end).line;
  return std::string(static_cast<std::size_t>(closing), '\n') +
         std::string(source.text().substr(source.line_start(closing + 1)));
}

std::optional<Lesson> read_lesson(const std::string& path, std::string bytes,
                                  Diagnostics& diagnostics, const Typography& typography) {
  const std::size_t said = diagnostics.size();
  Lesson lesson;
  lesson.typography = typography;
  lesson.source = read_source(path, std::move(bytes), diagnostics);
  if (!lesson.source) return std::nullopt;
  Reading reading(*lesson.source, diagnostics);

  static const RE2 name(R"((?s)content/([^/]+)/(((?:\d+|[A-Z])\.\d+)-[^/]+)\.md)", RE2::Latin1);
  if (!RE2::FullMatch(path, name, &lesson.folder, &lesson.slug, &lesson.number)) {
    diagnostics.push_back(error_at({path, 0, 0, 1, ""}, "E-lesson-name",
                                   "a lesson's file is named after its number, as `1.2-a-title.md`",
                                   "rename the file; an appendix has a letter: `A.1-a-title.md`"));
    return std::nullopt;
  }
  const std::optional<Span> front = find_front_matter(reading);
  if (!front) return std::nullopt;
  LessonReader reader(lesson, reading);
  lesson.front = read_front_matter(*front, reader);
  lesson.document = reader.parse(without_front_matter(*lesson.source, *front), 1);
  reader.read_document();
  lesson.sound = diagnostics.size() == said;
  return lesson;
}

}  // namespace mjcourse
