#include "script/author_text.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string_view>

#include "base/utf8.h"

namespace mjcourse {

namespace {

// The bytes of a line before its UTF-16 column `column` (from 1).
std::size_t bytes_before(std::string_view line, int column) {
  std::size_t at = 0;
  int units = 1;
  while (at < line.size() && units < column) {
    const std::size_t end = character_end(line, at);
    units += end - at == 4 ? 2 : 1;  // what takes four bytes takes two units
    at = end;
  }
  return at;
}

// Does `token` stand at `at` as a whole, and not inside a longer name?
bool is_whole(std::string_view line, std::size_t at, std::string_view token) {
  const std::size_t end = at + token.size();
  const bool begins =
      at == 0 || !is_word_character(token.front()) || !is_word_character(line[at - 1]);
  const bool ends =
      end == line.size() || !is_word_character(token.back()) || !is_word_character(line[end]);
  return begins && ends;
}

// Where `token` stands nearest to byte `wanted`; without one, where it stands if only once.
std::optional<std::size_t> find_token(std::string_view line, std::string_view token,
                                      std::optional<std::size_t> wanted) {
  std::optional<std::size_t> best;
  if (token.empty()) return best;
  const auto distance = [&](std::size_t at) { return at > *wanted ? at - *wanted : *wanted - at; };
  for (std::size_t at = line.find(token); at != line.npos; at = line.find(token, at + 1)) {
    if (!is_whole(line, at, token)) continue;
    if (best && !wanted) return std::nullopt;
    if (!best || distance(at) <= distance(*best)) best = at;
  }
  return best;
}

}  // namespace

// The offset after the last that is more than white space and semicolons.
std::size_t AuthorText::end() const {
  const std::size_t last = lines_.text().find_last_not_of(" \t\r\n;");
  return last == std::string_view::npos ? 0 : last + 1;
}

void AuthorText::point_at_end(ScriptError& error) const {
  const Position stop = lines_.position(end());
  error.line = stop.line;
  error.column = stop.column;
  error.width = 1;
  if (!error.message.starts_with(kTooEarly)) error.message.insert(0, kTooEarly);
}

void AuthorText::point_at(const Exception& exception, int line, ScriptError& error) const {
  const auto mark = [&](std::string_view text, std::size_t begin, std::string_view marked) {
    error.column = 1 + count_characters(text.substr(0, begin));
    error.width = std::max(1, count_characters(marked));
  };
  if (line < 1) return;
  if (line > lines_.line_count()) return point_at_end(error);
  error.line = line;
  const std::string_view text = lines_.line(line);
  std::optional<std::size_t> reported;
  if (exception.column > 0) {
    const std::string_view run = run_.line(line);
    reported = place_without_guards(run, bytes_before(run, exception.column));
  }
  for (const std::string& token : exception.tokens) {
    const auto at = find_token(text, token, reported);
    if (at) return mark(text, *at, token);
  }
  if (reported) {
    // of a call, JavaScriptCore points at the bracket: what is called stands before it
    std::size_t begin = *reported;
    while (begin > 0 && (is_word_character(text[begin - 1]) || text[begin - 1] == '.')) --begin;
    return mark(text, begin, text.substr(begin, *reported - begin));
  }
  const std::size_t first = std::min(text.find_first_not_of(" \t"), text.size());
  mark(text, first, text.substr(first));
}

}  // namespace mjcourse
