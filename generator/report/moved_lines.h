// The lines of a diff that only stand elsewhere.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/line_diff.h"

namespace mjcourse {

struct MovedLines {
  std::vector<char> moved;         // for each line of the diff
  std::vector<std::string> notes;  // "lines 20-22 moved below line 30"
};

MovedLines moved_lines(const std::vector<DiffLine>& lines, const SameLine& same);

}  // namespace mjcourse
