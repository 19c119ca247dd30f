#include "base/utf8.h"

#include <algorithm>
#include <clocale>
#include <cstdint>
#include <cstdio>
#include <cwchar>
#include <cwctype>

#include "base/code_points.h"

namespace mjcourse {
namespace {

// The code of the control character at `at`, or nothing. Those of two bytes, U+0080 to U+009F, a
// terminal obeys as it does an escape: U+009B begins what U+001B and `[` do.
std::optional<std::uint8_t> control_at(std::string_view text, std::size_t at) {
  const auto byte = static_cast<std::uint8_t>(text[at]);
  if (byte < 0x20 || byte == 0x7F) return byte;
  if (byte != 0xC2 || at + 1 == text.size()) return std::nullopt;
  const auto second = static_cast<std::uint8_t>(text[at + 1]);
  return second >= 0x80 && second < 0xA0 ? std::optional(second) : std::nullopt;
}

// Does what stands at `at` have a line shown in another order than it has, or broken in two: U+2028
// to U+202E, U+2066 to U+2069? All of these have three bytes.
bool is_layout_at(std::string_view text, std::size_t at) {
  if (text.size() < at + 3 || text[at] != '\xE2') return false;
  const auto second = static_cast<std::uint8_t>(text[at + 1]);
  const auto third = static_cast<std::uint8_t>(text[at + 2]);
  return (second == 0x80 && third >= 0xA8 && third <= 0xAE) ||
         (second == 0x81 && third >= 0xA6 && third <= 0xA9);
}

bool has_unreadable(std::string_view text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (control_at(text, at) || is_layout_at(text, at)) return true;
  }
  return false;
}

// "\\n", "\\x1b".
std::string escape_of(std::uint8_t control) {
  if (control == '\n') return "\\n";
  if (control == '\r') return "\\r";
  if (control == '\t') return "\\t";
  char text[8];
  std::snprintf(text, sizeof text, "\\x%02x", static_cast<unsigned>(control));
  return text;
}

// "\\u202e", of one well-formed sequence.
std::string escape_of_point(std::uint32_t point) {
  char text[12];
  std::snprintf(text, sizeof text, "\\u%04x", static_cast<unsigned>(point));
  return text;
}

// The C library's own locale, which needs no file and knows the letters of every language; null
// where there is none.
locale_t unicode_locale() {
  static const locale_t unicode = newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);
  return unicode;
}

void append_utf8(std::string& text, std::uint32_t point) {
  const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (point < 0x80) return add(point);
  if (point < 0x800) {
    add(0xC0 | point >> 6);
  } else {
    if (point < 0x10000) {
      add(0xE0 | point >> 12);
    } else {
      add(0xF0 | point >> 18);
      add(0x80 | (point >> 12 & 0x3F));
    }
    add(0x80 | (point >> 6 & 0x3F));
  }
  add(0x80 | (point & 0x3F));
}

}  // namespace

int count_characters(std::string_view text) {
  return static_cast<int>(
      std::count_if(text.begin(), text.end(), [](char c) { return !is_continuation(c); }));
}

int count_columns(std::string_view text) {
  const auto plain = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
  if (std::all_of(text.begin(), text.end(), plain) || unicode_locale() == nullptr) {
    return count_characters(text);
  }
  const locale_t before = uselocale(unicode_locale());  // of this thread
  int columns = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = std::max<std::size_t>(1, sequence_length(text.substr(at)));
    const int width = wcwidth(static_cast<wchar_t>(code_point(text.substr(at, length))));
    columns += width < 0 ? 1 : width;
    at += length;
  }
  uselocale(before);
  return columns;
}

std::vector<std::string_view> characters_of(std::string_view text) {
  std::vector<std::string_view> characters;
  for (std::size_t begin = 0, at = 1; at <= text.size(); ++at) {
    if (at < text.size() && is_continuation(text[at])) continue;
    characters.push_back(text.substr(begin, at - begin));
    begin = at;
  }
  return characters;
}

std::size_t character_start(std::string_view text, std::size_t at) {
  while (at > 0 && at < text.size() && is_continuation(text[at])) --at;
  return std::min(at, text.size());
}

std::optional<std::size_t> find_invalid_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = sequence_length(text.substr(at));
    if (length == 0) return at;
    at += length;
  }
  return std::nullopt;
}

std::optional<std::size_t> find_control_character(std::string_view text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool ends_line = text[at] == '\r' && (at + 1 == text.size() || text[at + 1] == '\n');
    if (control_at(text, at) && text[at] != '\n' && text[at] != '\t' && !ends_line) return at;
  }
  return std::nullopt;
}

std::string readable(std::string text) {
  if (!has_unreadable(text) && !find_invalid_utf8(text)) return text;
  std::string line;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = sequence_length(std::string_view(text).substr(at));
    if (length == 0) {
      line += "\uFFFD";
    } else if (const auto control = control_at(text, at)) {
      line += escape_of(*control);
    } else if (is_layout_at(text, at)) {
      line += escape_of_point(code_point(std::string_view(text).substr(at, length)));
    } else {
      line.append(text, at, length);
    }
    at += std::max<std::size_t>(1, length);
  }
  return line;
}

std::string readable_output(std::string_view line) {
  bool plain = !find_control_character(line) && !find_invalid_utf8(line);
  for (std::size_t at = 0; plain && at < line.size(); ++at) plain = !is_layout_at(line, at);
  return plain ? std::string(line) : readable(std::string(line));
}

std::string with_marks_for_unreadable(std::string_view line) {
  std::string text;
  for (std::size_t at = 0; at < line.size(); ++at) {
    const bool is_layout = is_layout_at(line, at);
    if (const auto control = control_at(line, at)) {
      text += line[at] == '\t' ? ' ' : '?';
      at += *control >= 0x80 ? 1 : 0;
    } else {
      text += is_layout ? '?' : line[at];
      at += is_layout ? 2 : 0;
    }
  }
  return text;
}

std::string utf8_of(std::u16string_view text) {
  const auto is_half = [&](std::size_t at, char16_t first) {
    return at < text.size() && (text[at] & 0xFC00) == first;
  };
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at) {
    std::uint32_t point = text[at];
    if (is_half(at, 0xD800) && is_half(at + 1, 0xDC00)) {
      point = 0x10000 + ((point - 0xD800) << 10) + (text[++at] - 0xDC00u);
    } else if (is_half(at, 0xD800) || is_half(at, 0xDC00)) {
      point = 0xFFFD;
    }
    append_utf8(result, point);
  }
  return result;
}

std::string lower_case_utf8(std::string_view text) {
  const locale_t unicode = unicode_locale();
  std::string lower;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = std::max<std::size_t>(1, sequence_length(text.substr(at)));
    const std::uint32_t letter = code_point(text.substr(at, length));
    append_utf8(lower, unicode == nullptr ? letter : towlower_l(letter, unicode));
    at += length;
  }
  return lower;
}

}  // namespace mjcourse
