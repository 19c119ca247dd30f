#include "lsp/text_point.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/utf8.h"

namespace mjcourse {
namespace {

using nlohmann::json;

// UTF-16 has two units for what UTF-8 has four bytes for.
int units_of(std::size_t bytes, Units units) {
  return units == Units::utf8 ? static_cast<int>(bytes) : bytes == 4 ? 2 : 1;
}

int number(const json& value) {
  const auto whole = value.get<std::int64_t>();
  return static_cast<int>(std::clamp<std::int64_t>(whole, 0, std::numeric_limits<int>::max() - 1));
}

}  // namespace

int count_units(std::string_view text, Units units) {
  int count = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = character_end(text, at);
    count += units_of(end - at, units);
    at = end;
  }
  return count;
}

std::size_t offset_of(const SourceText& text, TextPoint point, Units units) {
  if (point.line >= text.line_count()) return text.text().size();
  const std::string_view line = text.line(point.line + 1);
  std::size_t at = 0;
  for (int left = point.unit; at < line.size();) {
    const std::size_t end = character_end(line, at);
    left -= units_of(end - at, units);
    if (left < 0) break;
    at = end;
  }
  return text.line_start(point.line + 1) + at;
}

TextPoint point_of(const SourceText& text, std::size_t offset, Units units) {
  const int line = text.position(offset).line;
  const std::size_t start = text.line_start(line);
  const std::size_t end = std::min(offset, text.text().size());
  return {line - 1, count_units(text.text().substr(start, end - start), units)};
}

TextRange range_of(const SourceText& text, Span span, Units units) {
  return {point_of(text, span.begin, units), point_of(text, span.end, units)};
}

TextPoint read_point(const json& point) {
  return {number(point.at("line")), number(point.at("character"))};
}

TextRange read_range(const json& range) {
  return {read_point(range.at("start")), read_point(range.at("end"))};
}

json json_of(const TextRange& range) {
  const auto point = [](TextPoint at) { return json{{"line", at.line}, {"character", at.unit}}; };
  return {{"start", point(range.begin)}, {"end", point(range.end)}};
}

}  // namespace mjcourse
