#include "lesson/syntax/offsets.h"

#include <algorithm>
#include <iterator>

namespace mjcourse {

Offsets Offsets::side_by_side(std::size_t begin, std::size_t end) {
  Offsets offsets;
  offsets.append_run(end - begin + 1, begin, true);
  return offsets;
}

void Offsets::push_back(std::size_t offset) {
  append_run(1, offset, true);
}

void Offsets::append_still(std::size_t count, std::size_t offset) {
  append_run(count, offset, false);
}

void Offsets::append(const Offsets& other, std::size_t begin, std::size_t end) {
  auto run = std::upper_bound(other.runs_.begin(), other.runs_.end(), begin,
                              [](std::size_t index, const Run& at) { return index < at.begin; });
  if (run != other.runs_.begin()) --run;
  while (begin < end) {
    const auto next = std::next(run);
    const std::size_t stop = next == other.runs_.end() ? end : std::min(end, next->begin);
    append_run(stop - begin, other[begin], run->moves);
    begin = stop;
    run = next;
  }
}

std::size_t Offsets::operator[](std::size_t index) const {
  const auto behind =
      std::upper_bound(runs_.begin(), runs_.end(), index,
                       [](std::size_t at, const Run& run) { return at < run.begin; });
  const Run& run = *std::prev(behind);
  return run.offset + (run.moves ? index - run.begin : 0);
}

// A run of one byte may go on either way.
void Offsets::append_run(std::size_t count, std::size_t offset, bool moves) {
  if (count == 0) return;
  const std::size_t begin = size_;
  size_ += count;
  if (!runs_.empty()) {
    Run& last = runs_.back();
    const std::size_t length = begin - last.begin;
    if ((last.moves || length == 1) && (moves || count == 1) && offset == last.offset + length) {
      last.moves = true;
      return;
    }
    if ((!last.moves || length == 1) && (!moves || count == 1) && offset == last.offset) {
      last.moves = false;
      return;
    }
  }
  runs_.push_back({begin, offset, moves});
}

}  // namespace mjcourse
