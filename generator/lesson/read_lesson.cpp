#include "lesson/read_lesson.h"

#include <regex>
#include <string_view>
#include <utility>

#include "base/utf8.h"
#include "lesson/front_matter.h"
#include "lesson/lesson_reader.h"

namespace mjcourse {
namespace {

// Report the first byte that is no UTF-8, with an excerpt that is.
void report_invalid_utf8(const std::string& path, std::string bytes, std::size_t at,
                         Diagnostics& diagnostics) {
  constexpr std::string_view hex = "0123456789ABCDEF";
  const auto byte = static_cast<unsigned char>(bytes[at]);
  const std::string code{hex[byte >> 4], hex[byte & 15]};
  for (std::optional<std::size_t> bad = at; bad; bad = find_invalid_utf8(bytes)) {
    bytes.replace(*bad, 1, "\uFFFD");
  }
  const SourceText source(path, std::move(bytes));
  Reading(source, diagnostics)
      .error("E-not-utf8", {at, at + 3}, "byte 0x" + code + " is not UTF-8",
             "save the file as UTF-8");
}

}  // namespace

std::shared_ptr<const SourceText> read_source(const std::string& path, std::string bytes,
                                              Diagnostics& diagnostics) {
  if (const auto bad = find_invalid_utf8(bytes)) {
    report_invalid_utf8(path, std::move(bytes), *bad, diagnostics);
    return nullptr;
  }
  return std::make_shared<SourceText>(path, std::move(bytes));
}

std::string without_front_matter(const SourceText& source, Span front) {
  const int closing = source.position(front.end).line;
  return std::string(static_cast<std::size_t>(closing), '\n') +
         std::string(source.text().substr(source.line_start(closing + 1)));
}

std::optional<Lesson> read_lesson(const std::string& path, std::string bytes,
                                  Diagnostics& diagnostics) {
  Lesson lesson;
  lesson.source = read_source(path, std::move(bytes), diagnostics);
  if (!lesson.source) return std::nullopt;
  Reading reading(*lesson.source, diagnostics);

  static const std::regex name(R"(content/([^/]+)/((\d+\.\d+)-[^/]+)\.md)");
  std::smatch parts;
  if (!std::regex_match(path, parts, name)) {
    diagnostics.push_back(error_at({path, 0, 0, 1, ""}, "E-lesson-name",
                                   "a lesson's file is named after its number, as `1.2-a-title.md`",
                                   "rename the file"));
    return std::nullopt;
  }
  lesson.folder = parts[1];
  lesson.slug = parts[2];
  lesson.number = parts[3];

  const std::optional<Span> front = find_front_matter(reading);
  if (!front) return std::nullopt;
  LessonReader reader(lesson, reading);
  lesson.front = read_front_matter(*front, reader);
  lesson.document = parse_markdown(without_front_matter(*lesson.source, *front));
  reader.read_document();
  return lesson;
}

}  // namespace mjcourse
