#include "course/flow_list.h"

#include <algorithm>
#include <string_view>

namespace mjcourse {
namespace {

// Behind the text in quotes that begins at `at`. `\"` inside of "…" is a quote, as is `''` of '…'.
std::size_t skip_quoted(std::string_view text, std::size_t at) {
  const char quote = text[at];
  for (++at; at < text.size(); ++at) {
    const bool doubled = quote == '\'' && text.substr(at, 2) == "''";
    if (doubled || (quote == '"' && text[at] == '\\')) {
      ++at;
    } else if (text[at] == quote) {
      break;
    }
  }
  return std::min(at + 1, text.size());
}

struct Bracket {
  std::size_t close;  // the `]`
  std::size_t end;    // of what stands before it, without comments: "a, b" or "a, b,"
};

// The bracket that ends the list, which begins at `open`.
std::optional<Bracket> find_bracket(std::string_view text, std::size_t open) {
  std::size_t end = open + 1;
  int depth = 0;
  for (std::size_t at = open; at < text.size();) {
    const char c = text[at];
    const bool starts =
        at == open || std::string_view(" \t\r\n[{,:").find(text[at - 1]) != text.npos;
    if (c == '#' && starts) {
      at = std::min(text.find('\n', at), text.size());
    } else if ((c == '"' || c == '\'') && starts) {
      end = at = skip_quoted(text, at);
    } else {
      if (c == '[' || c == '{') ++depth;
      if ((c == ']' || c == '}') && --depth == 0) return Bracket{at, end};
      ++at;
      if (std::string_view(" \t\r\n").find(c) == std::string_view::npos) end = at;
    }
  }
  return std::nullopt;
}

// "\n    " where the item at `at` is the first of its line, else "".
std::string line_break_before(const std::string& text, std::size_t at) {
  const std::size_t word = at == 0 ? text.npos : text.find_last_not_of(' ', at - 1);
  if (word == text.npos || text[word] != '\n') return "";
  const bool crlf = word > 0 && text[word - 1] == '\r';
  return (crlf ? "\r" : "") + text.substr(word, at - word);
}

// Behind the last item; where each has a line, on a line of its own, behind that one's comment.
std::string append(std::string text, std::size_t last, const Bracket& bracket,
                   const std::string& item) {
  const bool comma = text[bracket.end - 1] == ',';
  const std::string line_break = line_break_before(text, last);
  const std::size_t line_end = std::min(text.find('\n', bracket.end), text.size());
  if (line_break.empty() || bracket.close < line_end) {
    const std::string space = line_break.empty() ? " " : line_break;
    return text.insert(bracket.end, (comma ? "" : ",") + space + item);
  }
  const bool crlf = text[line_end - 1] == '\r';
  text.insert(line_end - (crlf ? 1 : 0), line_break + item + (comma ? "," : ""));
  return comma ? text : text.insert(bracket.end, ",");
}

}  // namespace

std::optional<std::string> insert_into_flow_list(const std::string& text, std::size_t open,
                                                 const std::vector<std::size_t>& items,
                                                 std::size_t index, const std::string& item) {
  if (open >= text.size() || text[open] != '[') return std::nullopt;
  const std::optional<Bracket> bracket = find_bracket(text, open);
  if (!bracket) return std::nullopt;
  std::string result = text;
  if (items.empty()) return result.insert(open + 1, item);
  if (index == items.size()) return append(std::move(result), items.back(), *bracket, item);
  const std::string line_break = line_break_before(text, items[index]);
  return result.insert(items[index], item + "," + (line_break.empty() ? " " : line_break));
}

}  // namespace mjcourse
