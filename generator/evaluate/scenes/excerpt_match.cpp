#include "evaluate/scenes/excerpt_match.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "base/nearest.h"
#include "base/text_lines.h"

namespace mjcourse {
namespace {

constexpr std::string_view kEllipsis = "…";

struct Line {
  int number;
  std::string text;  // without indentation

  bool operator==(const Line& other) const { return text == other.text; }
};
using Lines = std::vector<Line>;

// All lines that are not blank.
Lines written_lines(std::string_view text) {
  Lines lines;
  int number = 0;
  for (const std::string_view line : lines_of(text)) {
    ++number;
    if (!trimmed(line).empty()) lines.push_back({number, std::string(trimmed(line))});
  }
  return lines;
}

// The pieces between the lines that skip.
std::vector<Lines> pieces_of(const Lines& lines) {
  std::vector<Lines> pieces(1);
  for (const Line& line : lines) {
    if (skips_lines(line.text)) {
      pieces.emplace_back();
    } else {
      pieces.back().push_back(line);
    }
  }
  std::erase_if(pieces, [](const Lines& piece) { return piece.empty(); });
  return pieces;
}

// How many lines of `piece` are those of `whole` from `at` on: in a row from the first, and in all.
std::pair<std::size_t, std::size_t> likeness(const Lines& piece, const Lines& whole,
                                             std::size_t at) {
  std::size_t in_a_row = 0, in_all = 0;
  for (std::size_t i = 0; i < piece.size() && at + i < whole.size(); ++i) {
    if (piece[i] != whole[at + i]) continue;
    if (in_a_row == i) ++in_a_row;
    ++in_all;
  }
  return {in_a_row, in_all};
}

// `piece` is nowhere in `whole` from `from` on: where it almost is.
ExcerptMismatch nearest_place(const Lines& piece, const Lines& whole, std::size_t from) {
  std::pair<std::size_t, std::size_t> best{0, 0};
  std::size_t best_at = whole.size();
  for (std::size_t at = from; at < whole.size(); ++at) {
    if (const auto like = likeness(piece, whole, at); like > best) {
      std::tie(best, best_at) = std::pair{like, at};
    }
  }
  if (best.second > 0) {
    const std::size_t there = best_at + best.first;
    return {piece[best.first].number, there < whole.size() ? whole[there].number : 0};
  }
  std::vector<std::string> candidates;
  for (std::size_t at = from; at < whole.size(); ++at) candidates.push_back(whole[at].text);
  const std::string similar = nearest(piece.front().text, candidates);
  const auto found = std::find_if(whole.begin() + static_cast<std::ptrdiff_t>(from), whole.end(),
                                  [&](const Line& line) { return line.text == similar; });
  return {piece.front().number, found != whole.end() ? found->number : 0};
}

}  // namespace

bool skips_lines(std::string_view line) {
  line = trimmed(line);
  return line == kEllipsis ||
         (line.starts_with("<!--") && line.ends_with("-->") && line.find(kEllipsis) != line.npos);
}

std::optional<ExcerptMismatch> find_excerpt_mismatch(std::string_view excerpt,
                                                     std::string_view whole) {
  const Lines lines = written_lines(whole);
  auto from = lines.begin();
  for (const Lines& piece : pieces_of(written_lines(excerpt))) {
    const auto found = std::search(from, lines.end(), piece.begin(), piece.end());
    if (found == lines.end()) {
      return nearest_place(piece, lines, static_cast<std::size_t>(from - lines.begin()));
    }
    from = found + static_cast<std::ptrdiff_t>(piece.size());
  }
  return std::nullopt;
}

}  // namespace mjcourse
