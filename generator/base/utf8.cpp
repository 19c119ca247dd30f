#include "base/utf8.h"

#include <unicase.h>
#include <unistr.h>
#include <uniwidth.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "base/code_points.h"

namespace mjcourse {
namespace {

const std::uint8_t* bytes_of(std::string_view text) {
  return reinterpret_cast<const std::uint8_t*>(text.data());
}

struct Character {
  std::size_t length;  // in bytes
  bool well_formed;    // else it is a single byte
  ucs4_t point;
};

Character character_at(std::string_view text, std::size_t at) {
  const std::uint8_t first = bytes_of(text)[at];
  if (first < 0x80) return {1, true, first};
  ucs4_t point = 0;
  const int length = u8_mbtoucr(&point, bytes_of(text) + at, text.size() - at);
  if (length < 0) return {1, false, point};
  return {static_cast<std::size_t>(length), true, point};
}

// Where the first is of which `is` says so.
template <typename Is>
std::optional<std::size_t> find_character(std::string_view text, Is is) {
  for (std::size_t at = 0; at < text.size();) {
    const Character c = character_at(text, at);
    if (is(c, at)) return at;
    at += c.length;
  }
  return std::nullopt;
}

// A terminal obeys U+0080 to U+009F as it does an escape: U+009B begins what U+001B and `[` do.
bool is_control(const Character& c) {
  return c.well_formed && (c.point < 0x20 || (c.point >= 0x7F && c.point < 0xA0));
}

// Does it have a line shown in another order than it has, or broken in two?
bool is_layout(const Character& c) {
  return c.well_formed &&
         ((c.point >= 0x2028 && c.point <= 0x202E) || (c.point >= 0x2066 && c.point <= 0x2069));
}

// "\\n", "\\x1b", "\\u202e".
std::string escape_of(ucs4_t point) {
  if (point == '\n') return "\\n";
  if (point == '\r') return "\\r";
  if (point == '\t') return "\\t";
  char text[12];
  std::snprintf(text, sizeof text, point < 0x100 ? "\\x%02x" : "\\u%04x",
                static_cast<unsigned>(point));
  return text;
}

}  // namespace

int count_characters(std::string_view text) {
  return static_cast<int>(
      std::count_if(text.begin(), text.end(), [](char c) { return !is_continuation(c); }));
}

int count_columns(std::string_view text) {
  int columns = 0;
  for (std::size_t at = 0; at < text.size();) {
    const Character c = character_at(text, at);
    const int width = c.well_formed ? uc_width(c.point, "UTF-8") : -1;
    columns += width < 0 ? 1 : width;
    at += c.length;
  }
  return columns;
}

std::vector<std::string_view> characters_of(std::string_view text) {
  std::vector<std::string_view> characters;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = character_end(text, at);
    characters.push_back(text.substr(at, end - at));
    at = end;
  }
  return characters;
}

std::size_t character_start(std::string_view text, std::size_t at) {
  while (at > 0 && at < text.size() && is_continuation(text[at])) --at;
  return std::min(at, text.size());
}

std::size_t character_end(std::string_view text, std::size_t at) {
  do ++at;
  while (at < text.size() && is_continuation(text[at]));
  return at;
}

std::optional<std::size_t> find_invalid_utf8(std::string_view text) {
  const std::uint8_t* invalid = u8_check(bytes_of(text), text.size());
  if (invalid == nullptr) return std::nullopt;
  return static_cast<std::size_t>(invalid - bytes_of(text));
}

std::optional<std::size_t> find_control_character(std::string_view text) {
  return find_character(text, [&](const Character& c, std::size_t at) {
    const bool ends_line = c.point == '\r' && (at + 1 == text.size() || text[at + 1] == '\n');
    return is_control(c) && c.point != '\n' && c.point != '\t' && !ends_line;
  });
}

std::string readable(std::string_view text) {
  std::string line;
  for (std::size_t at = 0; at < text.size();) {
    const Character c = character_at(text, at);
    if (!c.well_formed) {
      line += "\uFFFD";
    } else if (is_control(c) || is_layout(c)) {
      line += escape_of(c.point);
    } else {
      line.append(text, at, c.length);
    }
    at += c.length;
  }
  return line;
}

std::string readable_output(std::string_view line) {
  const bool plain =
      !find_control_character(line) && !find_character(line, [](const Character& c, std::size_t) {
        return !c.well_formed || is_layout(c);
      });
  return plain ? std::string(line) : readable(line);
}

std::string with_marks_for_unreadable(std::string_view line) {
  std::string text;
  for (std::size_t at = 0; at < line.size();) {
    const Character c = character_at(line, at);
    if (is_control(c) || is_layout(c)) {
      text += c.point == '\t' ? ' ' : '?';
    } else {
      text.append(line, at, c.length);
    }
    at += c.length;
  }
  return text;
}

std::string code_point_of(std::string_view text) {
  char name[12];
  std::snprintf(name, sizeof name, "U+%04X", static_cast<unsigned>(character_at(text, 0).point));
  return name;
}

std::string utf8_of(std::u16string_view text) {
  const auto* units = reinterpret_cast<const std::uint16_t*>(text.data());
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] < 0x80) {
      result += static_cast<char>(text[at++]);
      continue;
    }
    ucs4_t point = 0;  // U+FFFD of what is no character
    at += static_cast<std::size_t>(u16_mbtouc(&point, units + at, text.size() - at));
    std::array<std::uint8_t, 6> bytes{};
    const int length = u8_uctomb(bytes.data(), point, bytes.size());
    result.append(bytes.begin(), bytes.begin() + length);
  }
  return result;
}

std::string lower_case_utf8(std::string_view text) {
  std::size_t length = 0;
  const std::unique_ptr<std::uint8_t, decltype(&std::free)> lower(
      u8_tolower(bytes_of(text), text.size(), "", nullptr, nullptr, &length), &std::free);
  return lower ? std::string(lower.get(), lower.get() + length) : std::string(text);
}

}  // namespace mjcourse
