#include "evaluate/context/fence_extent.h"

#include <algorithm>
#include <string_view>

namespace mjcourse {
namespace {

// Without the spaces, list markers' indentation and `>` of what the fence stands in: so many
// quotes.
std::string_view bare(std::string_view line, std::ptrdiff_t quotes) {
  for (;; --quotes) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (quotes == 0 || !line.starts_with('>')) break;
    line.remove_prefix(1);
  }
  return line.substr(0, line.find_last_not_of(" \t\r") + 1);
}

}  // namespace

Span fence_extent(const SourceText& lesson, Span opening) {
  const std::string_view open = lesson.text().substr(opening.begin);
  const char mark = open[0];
  const std::size_t length = std::min(open.find_first_not_of(mark), open.size());
  const int first = lesson.position(opening.begin).line;
  const std::size_t before = opening.begin - lesson.line_start(first);
  const std::ptrdiff_t quotes = std::ranges::count(lesson.line(first).substr(0, before), '>');
  for (int line = first + 1; line <= lesson.line_count(); ++line) {
    const std::string_view text = bare(lesson.line(line), quotes);
    const bool closes = text.size() >= length && text.find_first_not_of(mark) == text.npos;
    if (closes) return {opening.begin, lesson.line_start(line) + lesson.line(line).size()};
  }
  return {opening.begin, lesson.text().size()};
}

}  // namespace mjcourse
