#include "report/wrapped.h"

#include <algorithm>
#include <vector>

#include "base/utf8.h"

namespace mjcourse {
namespace {

// The parts of `text` between blanks, of which those in backticks are none.
std::vector<std::string_view> parts_of(std::string_view text, bool code_is_whole) {
  std::vector<std::string_view> parts;
  bool in_code = false;
  std::size_t begin = 0;
  for (std::size_t at = 0; at <= text.size(); ++at) {
    if (at < text.size() && text[at] == '`') in_code = !in_code && code_is_whole;
    if (at < text.size() && (text[at] != ' ' || in_code)) continue;
    parts.push_back(text.substr(begin, at - begin));
    begin = at + 1;
  }
  return parts;
}

// Those that no line of `room` columns can hold, in smaller ones.
std::vector<std::string_view> fitting_parts(std::string_view text, int room) {
  std::vector<std::string_view> parts;
  for (const std::string_view part : parts_of(text, true)) {
    if (count_columns(part) <= room) {
      parts.push_back(part);
    } else {
      const std::vector<std::string_view> smaller = parts_of(part, false);
      parts.insert(parts.end(), smaller.begin(), smaller.end());
    }
  }
  return parts;
}

}  // namespace

std::string wrapped(std::string_view text, int width, int indent, int at) {
  const std::string line_end = "\n" + std::string(static_cast<std::size_t>(indent), ' ');
  std::string lines;
  bool empty = at <= indent;  // is the line
  bool first = true;
  for (const std::string_view part : fitting_parts(text, width - indent)) {
    const int columns = count_columns(part);
    if (!empty && at + (first ? 0 : 1) + columns > width) {
      lines += line_end;
      at = indent;
    } else if (!first) {
      lines += ' ';
      ++at;
    }
    lines += part;
    at += columns;
    empty = first = false;
  }
  return lines;
}

}  // namespace mjcourse
