#include "lesson/syntax/located_text.h"

#include <algorithm>

#include "base/utf8.h"

namespace mjcourse {
namespace {

// The offset `count` characters after `at`, not past the line's end.
std::size_t skip_characters(const std::string& text, std::size_t at, int count) {
  const auto line_end = std::min(text.find('\n', at), text.size());
  const std::size_t from = at;
  while (at < line_end && count_characters({text.data() + from, at + 1 - from}) <= count) ++at;
  return at;
}

}  // namespace

Span LocatedText::span_at(int line, int column, int width) const {
  std::size_t start = 0;
  for (int i = 1; i < line; ++i) {
    const std::size_t end = text.find('\n', start);
    if (end == std::string::npos) break;
    start = end + 1;
  }
  const std::size_t begin = skip_characters(text, start, column - 1);
  return span(begin, skip_characters(text, begin, width));
}

LocatedText LocatedText::part(std::size_t begin, std::size_t end) const {
  LocatedText part{text.substr(begin, end - begin), {}};
  if (!offsets.empty()) part.offsets.append(offsets, begin, std::min(end + 1, offsets.size()));
  return part;
}

void LocatedText::append_line(const LocatedText& more) {
  if (offsets.empty()) {
    *this = more;
    return;
  }
  text += "\n" + more.text;
  offsets.append(more.offsets, 0, more.offsets.size());
}

LocatedText located(const SourceText& source, Span span) {
  return {std::string(source.text().substr(span.begin, span.end - span.begin)),
          Offsets::side_by_side(span.begin, span.end)};
}

}  // namespace mjcourse
