#include "lsp/markdown.h"

#include <algorithm>
#include <cstddef>

#include "base/utf8.h"

namespace mjcourse {
namespace {

bool is_mark(char c) {
  return c > ' ' && c < '\x7f' && !is_letter_or_digit(c);
}

std::size_t most_backticks(std::string_view words) {
  std::size_t most = 0, now = 0;
  for (const char c : words) {
    now = c == '`' ? now + 1 : 0;
    most = std::max(most, now);
  }
  return most;
}

}  // namespace

std::string escaped_for_markdown(std::string_view words) {
  std::string text;
  for (const char c : readable(words)) {
    // Some readers take an escaped `<` for HTML all the same.
    if (c == '<') {
      text += "&lt;";
    } else {
      text += is_mark(c) ? std::string{'\\', c} : std::string{c};
    }
  }
  return text;
}

std::string code_for_markdown(std::string_view words) {
  if (words.empty()) return "";
  const std::string line = readable(words);
  const std::string fence(most_backticks(line) + 1, '`');
  // A reader takes one blank away at each end.
  const std::string gap = fence.size() > 1 || line.starts_with(' ') ? " " : "";
  return fence + gap + line + gap + fence;
}

}  // namespace mjcourse
