// Is this the output that the lesson states?
//
// Lines are compared character by character, and numbers as numbers (evaluate/printed_number.h):
// two agree when they differ by at most one unit in the last place that the lesson prints. A number
// without digits after its point counts something, and must be the same. `[..]` in the lesson
// stands for any text on its line.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "report/line_diff.h"

namespace mjcourse {

// `tolerance` is absolute and replaces the unit of the last place.
bool lines_agree(std::string_view stated, std::string_view real, std::optional<double> tolerance);

// The lines on which the two texts differ, in order: the shortest edit between them. Empty when the
// output is as stated. White space at a line's end and at the text's end does not count.
std::vector<DiffLine> output_changes(std::string_view stated, std::string_view real,
                                     std::optional<double> tolerance);

}  // namespace mjcourse
