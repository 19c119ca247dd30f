#include "report/diagnostic.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/utf8.h"

namespace mjcourse {

namespace {

// What a message quotes may be as long as a lesson.
constexpr std::size_t kMostSaid = 2000;
// Of a longer line, an excerpt has this much before and behind the place, in bytes.
constexpr std::size_t kLongLine = 4000, kAround = 400;

// `text` in one line, without what is too much in its middle.
std::string spoken(std::string text) {
  text = readable(std::move(text));
  if (text.size() <= kMostSaid) return text;
  const std::size_t end = character_start(text, kMostSaid / 2);
  const std::size_t begin = character_start(text, text.size() - kMostSaid / 2);
  return text.substr(0, end) + " … " + text.substr(begin);
}

}  // namespace

Diagnostic error_at(Place place, std::string id, std::string message, std::string cure) {
  Diagnostic error;
  error.id = std::move(id);
  error.place = std::move(place);
  error.message = spoken(std::move(message));
  error.cure = spoken(std::move(cure));
  return error;
}

void sort_by_place(Diagnostics& diagnostics) {
  std::stable_sort(diagnostics.begin(), diagnostics.end(),
                   [](const Diagnostic& a, const Diagnostic& b) {
                     return std::tie(a.place.file, a.place.line, a.place.column) <
                            std::tie(b.place.file, b.place.line, b.place.column);
                   });
}

bool concerns(const Diagnostic& diagnostic, const std::string& file) {
  return diagnostic.place.file == file ||
         std::any_of(diagnostic.notes.begin(), diagnostic.notes.end(),
                     [&](const Note& note) { return note.place.file == file; });
}

Place place_of(const SourceText& source, Span span) {
  const Position start = source.position(span.begin);
  const std::string_view line = source.line(start.line);
  const std::size_t offset = span.begin - std::min(span.begin, source.line_start(start.line));
  const std::string_view rest = line.substr(std::min(offset, line.size()));
  const std::size_t length = std::max(span.end, span.begin) - span.begin;
  const int width = std::max(1, count_characters(rest.substr(0, length)));
  Place place{source.path(), start.line, start.column, width, ""};
  if (line.size() <= kLongLine) {
    place.excerpt = line;
    return place;
  }
  const std::size_t begin = character_start(line, offset - std::min(offset, kAround));
  const std::size_t end = character_start(line, std::min(offset + kAround, line.size()));
  place.excerpt = line.substr(begin, end - begin);
  place.excerpt_column = source.position(source.line_start(start.line) + begin).column;
  return place;
}

}  // namespace mjcourse
