#include "lsp/messages.h"

#include <strings.h>

#include <charconv>
#include <istream>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string_view>

namespace mjcourse {
namespace {

constexpr std::size_t kLongestHeader = 4096;

// One line of a header, without its end. Nothing at the end, or where it is no header any more.
std::optional<std::string> read_header_line(std::istream& in) {
  std::string line;
  for (char c = 0; in.get(c);) {
    if (c == '\n') {
      if (line.ends_with('\r')) line.pop_back();
      return line;
    }
    line += c;
    if (line.size() > kLongestHeader) return std::nullopt;
  }
  return std::nullopt;
}

// "Content-Length: 12"; names of fields have no case.
std::optional<std::size_t> length_in(std::string_view line) {
  constexpr std::string_view name = "Content-Length:";
  if (line.size() < name.size() || strncasecmp(line.data(), name.data(), name.size()) != 0) {
    return std::nullopt;
  }
  line.remove_prefix(std::min(line.find_first_not_of(" \t", name.size()), line.size()));
  std::size_t length = 0;
  const auto read = std::from_chars(line.data(), line.data() + line.size(), length);
  return read.ec == std::errc() ? std::optional(length) : std::nullopt;
}

}  // namespace

std::optional<std::string> read_message(std::istream& in) {
  std::optional<std::size_t> length;
  for (;;) {
    const auto line = read_header_line(in);
    if (!line) return std::nullopt;
    if (const auto told = length_in(*line)) length = told;
    if (line->empty() && length) break;
  }
  if (*length > kLongestMessage) return std::nullopt;
  std::string body(*length, '\0');
  if (!in.read(body.data(), static_cast<std::streamsize>(body.size()))) return std::nullopt;
  return body;
}

nlohmann::json parse_message(const std::string& body) {
  using nlohmann::json;
  bool too_deep = false;
  const auto keep = [&](int depth, json::parse_event_t event, const json&) {
    const bool begins =
        event == json::parse_event_t::array_start || event == json::parse_event_t::object_start;
    too_deep = too_deep || (begins && depth >= kDeepestMessage);
    return !too_deep;
  };
  const json message = json::parse(body, keep, false);
  return too_deep ? json(json::value_t::discarded) : message;
}

void write_message(std::ostream& out, const std::string& body) {
  out << "Content-Length: " << body.size() << "\r\n\r\n" << body << std::flush;
}

}  // namespace mjcourse
