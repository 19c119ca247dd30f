#include "preview/page_change.h"

#include <algorithm>
#include <cstdio>
#include <string_view>

namespace mjcourse {
namespace {

constexpr std::string_view kBegin = "<!--lines", kEnd = "-->";

struct Piece {
  std::string_view mark;  // empty of the first: what stands before the text
  std::string_view text;
};

// The last is what stands behind the text.
std::vector<Piece> pieces_of(std::string_view html) {
  std::vector<Piece> pieces;
  std::string_view mark;
  for (;;) {
    const std::size_t text = html.find(kBegin);
    pieces.push_back({mark, html.substr(0, text)});
    if (text == html.npos) return pieces;
    html.remove_prefix(text);
    mark = html.substr(0, html.find(kEnd) + kEnd.size());
    html.remove_prefix(mark.size());
  }
}

}  // namespace

std::vector<PageMark> marks_of(const std::string& html) {
  std::vector<PageMark> marks;
  for (const Piece& piece : pieces_of(html)) {
    PageMark mark;
    const std::string text(piece.mark);
    if (std::sscanf(text.c_str(), "<!--lines %d-%d", &mark.first, &mark.last) != 2) continue;
    mark.running = text.find("running") != text.npos;
    marks.push_back(mark);
  }
  return marks;
}

std::optional<PageChange> page_change(const std::string& before, const std::string& after) {
  const std::vector<Piece> old = pieces_of(before), young = pieces_of(after);
  const auto same = [](const Piece& a, const Piece& b) { return a.text == b.text; };
  if (old.size() < 2 || young.size() < 2 || !same(old.front(), young.front()) ||
      !same(old.back(), young.back())) {
    return std::nullopt;
  }
  const auto [first_old, first_young] =
      std::mismatch(old.begin(), old.end() - 1, young.begin(), young.end() - 1, same);
  const auto [last_old, last_young] =
      std::mismatch(old.rbegin(), std::make_reverse_iterator(first_old), young.rbegin(),
                    std::make_reverse_iterator(first_young), same);
  PageChange change;
  change.first = static_cast<std::size_t>(first_old - old.begin()) - 1;
  change.count = static_cast<std::size_t>(last_old.base() - first_old);
  for (auto piece = first_young; piece != last_young.base(); ++piece) {
    change.html.append(piece->mark).append(piece->text);
  }
  return change;
}

}  // namespace mjcourse
