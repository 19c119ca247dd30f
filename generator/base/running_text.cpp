#include "base/running_text.h"

#include <cctype>

#include "base/utf8.h"

namespace mjcourse {

std::string with_single_blanks(std::string_view text) {
  std::string single;
  single.reserve(text.size());
  for (const char c : text) {
    if (std::isspace(static_cast<unsigned char>(c)) == 0) {
      single += c;
    } else if (!single.empty() && single.back() != ' ') {
      single += ' ';
    }
  }
  if (single.ends_with(' ')) single.pop_back();
  return single;
}

std::string beginning_of(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  const std::size_t end = text.rfind(' ', most);
  if (end != text.npos) return text.substr(0, end);
  return text.substr(0, character_start(text, most));  // of a script without blanks
}

}  // namespace mjcourse
