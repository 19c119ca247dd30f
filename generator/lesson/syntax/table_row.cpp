#include "lesson/syntax/table_row.h"

#include <algorithm>

#include "base/utf8.h"
#include "lesson/syntax/inline_length.h"

namespace mjcourse {
namespace {

// The next bar that no backslash precedes.
std::size_t next_bar(std::string_view row, std::size_t from) {
  for (std::size_t at = from; (at = row.find('|', at)) < row.size(); ++at) {
    if (at == 0 || row[at - 1] != '\\') return at;
  }
  return row.size();
}

}  // namespace

std::vector<RowCell> cells_of_row(std::string_view row) {
  constexpr const char* kBlanks = " \t\r\n";
  const std::size_t last = row.find_last_not_of(kBlanks);
  if (last == row.npos) return {};
  row = row.substr(0, last + 1);
  std::size_t begin = row.find_first_not_of(kBlanks);
  if (row[begin] == '|') ++begin;
  std::vector<RowCell> cells;
  while (begin < row.size()) {
    const std::size_t end = next_bar(row, begin);
    cells.push_back({begin, end});
    begin = end + 1;
  }
  return cells;
}

std::optional<CuttingBar> cutting_bar(std::string_view row) {
  CodeLengths codes;
  std::size_t length = 1;
  for (std::size_t at = 0; at < row.size(); at += length) {
    length = 1;
    if (row[at] == '\\') length = 2;
    if (row[at] != '`' && row[at] != '$') continue;
    const bool code = row[at] == '`';
    const std::size_t whole = code ? codes.at(row.substr(at)) : math_length(row.substr(at));
    if (code) length = backticks(row.substr(at));
    if (whole == 0) continue;
    const std::size_t bar = next_bar(row, at);
    const std::size_t behind = at + whole;
    // Of `|$HOME|$PATH|`, no dollar closes a formula.
    const bool word_follows = !code && behind < row.size() && is_letter_or_digit(row[behind]);
    if (bar < behind && word_follows) continue;
    if (bar < behind) return CuttingBar{bar, code ? "code" : "a formula"};
    length = whole;
  }
  return std::nullopt;
}

}  // namespace mjcourse
