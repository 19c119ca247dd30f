#include "report/diagnostic.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/utf8.h"

namespace mjcourse {

Diagnostic error_at(Place place, std::string id, std::string message, std::string cure) {
  Diagnostic error;
  error.id = std::move(id);
  error.place = std::move(place);
  error.message = readable(std::move(message));
  error.cure = readable(std::move(cure));
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
  return {source.path(), start.line, start.column, width, std::string(line)};
}

}  // namespace mjcourse
