#include "base/cpp_includes.h"

#include <re2/re2.h>

#include <algorithm>
#include <optional>

namespace mjcourse {
namespace {

constexpr std::string_view kBlanksOfLine = " \t\r";

std::string_view without_blanks_before(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(kBlanksOfLine), text.size()));
}

// Takes the comments, blanks and line ends that `text` begins with away. False where a comment has
// no end, or a comment's line goes on in the next.
bool skip_comments(std::string_view& text) {
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    if (text.starts_with("//")) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      const std::size_t last = text.substr(0, end).find_last_not_of(kBlanksOfLine);
      if (text[last] == '\\') return false;
      text.remove_prefix(end);
    } else if (text.starts_with("/*")) {
      const std::size_t end = text.find("*/", 2);
      if (end == text.npos) return false;
      text.remove_prefix(end + 2);
    } else {
      return true;
    }
  }
}

// Of `#include <vector>  // std::vector`: what is behind the word `include`.
std::optional<Include> parse_include(std::string_view line) {
  line = without_blanks_before(line);
  if (line.empty() || (line[0] != '<' && line[0] != '"')) return std::nullopt;
  const bool angled = line[0] == '<';
  const std::size_t end = line.find(angled ? '>' : '"', 1);
  if (end == line.npos) return std::nullopt;
  const std::string_view rest = without_blanks_before(line.substr(end + 1));
  if (!rest.empty() && !rest.starts_with("//")) return std::nullopt;
  return Include{std::string(line.substr(1, end - 1)), angled};
}

}  // namespace

std::vector<Include> leading_includes(std::string_view program) {
  std::vector<Include> includes;
  while (skip_comments(program) && program.starts_with('#')) {
    const std::string_view line = program.substr(0, program.find('\n'));
    program.remove_prefix(line.size());
    if (line.find('\\') != line.npos || line.find("/*") != line.npos) break;
    const std::string_view directive = without_blanks_before(line.substr(1));
    if (directive.starts_with("line ") || directive.starts_with("pragma once")) continue;
    if (!directive.starts_with("include")) break;
    std::optional<Include> include = parse_include(directive.substr(7));
    if (!include) break;
    includes.push_back(*std::move(include));
  }
  return includes;
}

std::vector<std::string> quoted_includes(std::string_view program) {
  static const RE2 form(R"re((?m)^[ \t]*#[ \t]*include[ \t]*"([^"\n]+)")re");
  re2::StringPiece rest(program.data(), program.size());
  std::vector<std::string> names;
  for (std::string name; RE2::FindAndConsume(&rest, form, &name);) names.push_back(name);
  return names;
}

bool draws(std::string_view program) {
  return std::ranges::any_of(leading_includes(program),
                             [](const Include& include) { return include.name == "GL/osmesa.h"; });
}

std::vector<std::string> linked_libraries(std::string_view program) {
  std::vector<std::string> libraries{"mujoco"};
  if (draws(program)) libraries.emplace_back("OSMesa");
  return libraries;
}

}  // namespace mjcourse
