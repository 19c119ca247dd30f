#include "evaluate/claims/fence_extent.h"

#include <algorithm>
#include <string_view>

namespace mjcourse {
namespace {

// Without the spaces, list markers' indentation and `>` of what the fence stands in.
std::string_view bare(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t>"), line.size()));
  return line.substr(0, line.find_last_not_of(" \t\r") + 1);
}

}  // namespace

Span fence_extent(const SourceText& lesson, Span opening) {
  const std::string_view open = lesson.text().substr(opening.begin);
  const char mark = open[0];
  const std::size_t length = std::min(open.find_first_not_of(mark), open.size());
  for (int line = lesson.position(opening.begin).line + 1; line <= lesson.line_count(); ++line) {
    const std::string_view text = bare(lesson.line(line));
    const bool closes = text.size() >= length && text.find_first_not_of(mark) == text.npos;
    if (closes) return {opening.begin, lesson.line_start(line) + lesson.line(line).size()};
  }
  return {opening.begin, lesson.text().size()};
}

}  // namespace mjcourse
