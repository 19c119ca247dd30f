#include "report/diff_text.h"

#include <algorithm>
#include <utility>

#include "report/changed_words.h"
#include "report/colours.h"
#include "report/moved_lines.h"

namespace mjcourse {
namespace {

constexpr double kAlike = 0.5;               // from here on marks under the words help
constexpr std::size_t kMostPairings = 2500;  // that are weighed

using Indices = std::vector<std::size_t>;

struct Row {
  std::string_view colour;
  std::string text;
};

// Neighbours in both texts: what goes there and what comes in its stead. What moved is kept apart.
struct Hunk {
  Indices gone, come;
};

std::vector<Hunk> hunks_of(const std::vector<DiffLine>& lines) {
  std::vector<Hunk> hunks;
  int next = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool gone = lines[i].kind == DiffLine::Kind::gone;
    if (hunks.empty() || lines[i].line != next) hunks.emplace_back();
    next = lines[i].line + (gone ? 1 : 0);
    (gone ? hunks.back().gone : hunks.back().come).push_back(i);
  }
  return hunks;
}

class DiffWriter {
 public:
  DiffWriter(const std::vector<DiffLine>& lines, const SameLine& same, const DiffStyle& style)
      : lines_(lines), style_(style), moves_(moved_lines(lines, same)) {
    for (const DiffLine& line : lines) {
      width_ = std::max(width_, std::to_string(line.line).size());
    }
    for (const Hunk& hunk : hunks_of(lines)) add(hunk);
  }

  std::string text() const {
    std::string text;
    const bool folds = rows_.size() > style_.most_rows;
    const std::size_t half = style_.most_rows / 2;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (folds && i == half) {
        text += std::string(width_, ' ') + " … " + std::to_string(rows_.size() - 2 * half) +
                " more lines …\n";
        i = rows_.size() - half;
      }
      const Row& row = rows_[i];
      const bool coloured = style_.colours && !row.colour.empty();
      text += coloured ? std::string(row.colour) + row.text + std::string(kPlain) : row.text;
      text += '\n';
    }
    for (const std::string& note : moves_.notes) text += note + "\n";
    return text;
  }

 private:
  void add(const Hunk& hunk) {
    std::size_t gone = 0, come = 0;
    const auto add_come = [&] {
      // Where it begins the hunk, it has the number of the line that it stands before.
      const bool begins = gone == 0 && come == 0;
      const std::size_t first = hunk.gone.empty() ? hunk.come[0] : hunk.gone[0];
      add_line(hunk.come[come], begins ? std::to_string(lines_[first].line) : "");
      ++come;
    };
    for (const auto& [i, j] : pairs(hunk)) {
      while (gone < i) add_gone(hunk.gone[gone++]);
      while (come < j) add_come();
      add_pair(hunk.gone[gone++], hunk.come[come++]);
    }
    while (gone < hunk.gone.size()) add_gone(hunk.gone[gone++]);
    while (come < hunk.come.size()) add_come();
  }

  // Which line became which, in order, so that what stands together is as alike as can be; lines
  // that have nothing in common stand together where nothing better is there.
  std::vector<std::pair<std::size_t, std::size_t>> pairs(const Hunk& hunk) const {
    const std::size_t n = hunk.gone.size(), m = hunk.come.size();
    if (n * m == 0 || n * m > kMostPairings) return {};
    constexpr double some = 0.01;
    std::vector<std::vector<double>> own(n, std::vector<double>(m, 0)),
        best(n + 1, std::vector<double>(m + 1, 0));
    for (std::size_t i = n; i-- > 0;) {
      for (std::size_t j = m; j-- > 0;) {
        const std::size_t a = hunk.gone[i], b = hunk.come[j];
        if (moves_.moved[a] == 0 && moves_.moved[b] == 0) {
          own[i][j] = some + changed_words(lines_[a].text, lines_[b].text).alike;
        }
        const double paired = own[i][j] > 0 ? own[i][j] + best[i + 1][j + 1] : 0;
        best[i][j] = std::max({paired, best[i + 1][j], best[i][j + 1]});
      }
    }
    std::vector<std::pair<std::size_t, std::size_t>> found;
    for (std::size_t i = 0, j = 0; i < n && j < m;) {
      if (own[i][j] > 0 && own[i][j] + best[i + 1][j + 1] >= best[i][j]) {
        found.emplace_back(i++, j++);
      } else {
        best[i + 1][j] >= best[i][j + 1] ? ++i : ++j;
      }
    }
    return found;
  }

  void add_gone(std::size_t index) { add_line(index, std::to_string(lines_[index].line)); }

  void add_line(std::size_t index, const std::string& number) {
    const DiffLine& line = lines_[index];
    const bool gone = line.kind == DiffLine::Kind::gone;
    const std::string margin = std::string(width_ - number.size(), ' ') + number;
    const char* sign = gone ? " -" : " +";
    rows_.push_back(
        {gone ? kRed : kGreen, margin + sign + (line.text.empty() ? "" : " " + line.text)});
  }

  void add_pair(std::size_t gone, std::size_t come) {
    const ChangedWords words = changed_words(lines_[gone].text, lines_[come].text);
    const std::string margin(width_ + 3, ' ');
    const bool marked = words.alike >= kAlike;
    add_gone(gone);
    if (marked && words.come.empty() && !words.gone.empty()) {
      rows_.push_back({"", margin + words.gone});
    }
    add_line(come, "");
    if (marked && !words.come.empty()) rows_.push_back({"", margin + words.come});
  }

  const std::vector<DiffLine>& lines_;
  DiffStyle style_;
  MovedLines moves_;
  std::size_t width_ = 0;  // of the line numbers
  std::vector<Row> rows_;
};

}  // namespace

std::string diff_text(const std::vector<DiffLine>& lines, const SameLine& same,
                      const DiffStyle& style) {
  return DiffWriter(lines, same, style).text();
}

}  // namespace mjcourse
