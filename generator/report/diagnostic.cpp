#include "report/diagnostic.h"

#include <algorithm>
#include <utility>

#include "base/utf8.h"

namespace mjcourse {

Diagnostic error_at(Place place, std::string id, std::string message, std::string cure) {
  Diagnostic error;
  error.id = std::move(id);
  error.place = std::move(place);
  error.message = std::move(message);
  error.cure = std::move(cure);
  return error;
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
