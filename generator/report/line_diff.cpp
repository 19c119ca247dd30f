#include "report/line_diff.h"

#include <algorithm>

namespace mjcourse {
namespace {

using Lines = std::vector<std::string_view>;

constexpr std::size_t kMostCells = 4 << 20;  // of the search's table

// The lines of two texts that differ from their first on, and what they have in common.
class Search {
 public:
  Search(const Lines& before, const Lines& after, const SameLine& same)
      : before_(before), after_(after), columns_(after.size() + 1) {
    if ((before.size() + 1) * columns_ > kMostCells) return;
    same_.resize(before.size() * after.size());
    common_.resize((before.size() + 1) * columns_);
    for (std::size_t i = before.size(); i-- > 0;) {
      for (std::size_t j = after.size(); j-- > 0;) {
        same_[i * after.size() + j] = same(before[i], after[j]) ? 1 : 0;
        common_[i * columns_ + j] =
            is_same(i, j) ? common(i + 1, j + 1) + 1 : std::max(common(i + 1, j), common(i, j + 1));
      }
    }
  }

  // `first` is the number of the first line.
  std::vector<DiffLine> changes(int first) const {
    std::vector<DiffLine> changes;
    for (std::size_t i = 0, j = 0; i < before_.size() || j < after_.size();) {
      const int line = first + static_cast<int>(i);
      if (i < before_.size() && j < after_.size() && is_same(i, j)) {
        ++i, ++j;
      } else if (j == after_.size() ||
                 (i < before_.size() && common(i + 1, j) >= common(i, j + 1))) {
        changes.push_back({DiffLine::Kind::gone, line, std::string(before_[i++])});
      } else {
        changes.push_back({DiffLine::Kind::come, line, std::string(after_[j++])});
      }
    }
    return changes;
  }

 private:
  bool is_same(std::size_t i, std::size_t j) const {
    return !same_.empty() && same_[i * after_.size() + j] != 0;
  }
  // The most lines that before[i..] and after[j..] have in common, in order.
  int common(std::size_t i, std::size_t j) const {
    return common_.empty() ? 0 : common_[i * columns_ + j];
  }

  const Lines& before_;
  const Lines& after_;
  std::size_t columns_;
  std::vector<char> same_;
  std::vector<int> common_;
};

}  // namespace

std::vector<DiffLine> line_diff(Lines before, Lines after, const SameLine& same) {
  // What is the same at both ends needs no search; most often that is all.
  std::size_t start = 0;
  while (start < std::min(before.size(), after.size()) && same(before[start], after[start])) {
    ++start;
  }
  before.erase(before.begin(), before.begin() + static_cast<std::ptrdiff_t>(start));
  after.erase(after.begin(), after.begin() + static_cast<std::ptrdiff_t>(start));
  while (!before.empty() && !after.empty() && same(before.back(), after.back())) {
    before.pop_back();
    after.pop_back();
  }
  return Search(before, after, same).changes(static_cast<int>(start) + 1);
}

}  // namespace mjcourse
