#include "lesson/syntax/is_text.h"

#include <algorithm>
#include <cstdio>
#include <optional>

#include "base/utf8.h"
#include "lesson/syntax/reading.h"

namespace mjcourse {
namespace {

constexpr std::size_t kMostText = 1 << 20;

// `bytes` up to the end of the line of `at`, where it is not text.
std::string readable_line(const std::string& bytes, std::size_t at) {
  const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
  std::string line = readable(bytes.substr(at, end - at));
  if (line.ends_with("\\r")) line.resize(line.size() - 2);
  return bytes.substr(0, at) + line;
}

}  // namespace

bool is_text(const std::string& path, const std::string& bytes, Diagnostics& diagnostics) {
  if (bytes.size() > kMostText) {
    diagnostics.push_back(
        error_at({path, 0, 0, 1, ""}, "E-text-size",
                 "a text file may be at most 1 MiB, and this one has " +
                     std::to_string(bytes.size()) + " bytes",
                 "make several of it; a program, a model or a picture is a file of its own"));
    return false;
  }
  const std::size_t invalid = find_invalid_utf8(bytes).value_or(bytes.size());
  const std::size_t control = find_control_character(bytes).value_or(bytes.size());
  const std::size_t at = std::min(invalid, control);
  if (at == bytes.size()) return true;
  // A control character of two bytes is U+0080 to U+009F, whose second byte is its number.
  const bool is_long = control < invalid && bytes[at] == '\xC2';
  char byte[8];
  std::snprintf(byte, sizeof byte, is_long ? "U+%04X" : "0x%02X",
                static_cast<unsigned>(bytes[at + (is_long ? 1 : 0)]) & 0xFFU);
  const SourceText source(path, readable_line(bytes, at));
  Reading reading(source, diagnostics);
  if (invalid < control) {
    reading.error("E-not-utf8", {at, at + 3}, std::string("byte ") + byte + " is not UTF-8",
                  "save the file as UTF-8");
  } else {
    reading.error(
        "E-control-character", {at, at + 2},
        std::string(is_long ? "" : "byte ") + byte + " is a control character, which no text holds",
        bytes[at] == '\r' ? "end lines with a line feed, also after a carriage return"
                          : "remove it");
  }
  return false;
}

}  // namespace mjcourse
