// LessonResults: all that was found out about one lesson.
// Tested by tests/generator/evaluate/scenes/pin_test.cpp.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "findings/claim.h"
#include "findings/result.h"
#include "findings/tally.h"

namespace mjcourse {

// Blocks of several lessons, each by its lesson's file and its index there.
using Blocks = std::set<std::pair<std::string, std::size_t>>;

struct LessonResults {
  std::map<std::size_t, Result> of_block;  // only of blocks that could be evaluated
  std::map<std::size_t, double> seconds;   // measured, of the blocks that take time
  std::set<std::size_t> open;  // blocks that are being worked on: their results are stand-ins
  Claims claims;               // in the order of the blocks
  Tally tally;

  // The result of block `index` if it is there and of this type.
  template <typename T>
  const T* get(std::size_t index) const {
    const auto found = of_block.find(index);
    return found == of_block.end() ? nullptr : std::get_if<T>(&found->second);
  }
};

// Those of a lesson, in the order of its blocks. They point into `results`.
std::vector<const PinComparison*> pins_of(const LessonResults& results);

}  // namespace mjcourse
