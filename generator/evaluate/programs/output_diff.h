// Is this the output that the lesson states?
//
// Lines are compared character by character, and numbers as numbers
// (evaluate/programs/printed_number.h): two agree when they differ by at most one unit in the last
// place that the lesson prints. A number without digits after its point counts something, and must
// be the same. `[..]` in the lesson stands for any text on its line.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "report/line_diff.h"

namespace mjcourse {

// How far a comparison may go back to try what stands behind a `[..]` at another place. Lines that
// want more than this are made for it: it takes seconds.
struct Retrials {
  std::size_t left = 100'000'000;  // characters
};

// `tolerance` is absolute and replaces the unit of the last place. Once no `retrials` are left,
// lines with a `[..]` may be found to differ that agree.
bool lines_agree(std::string_view stated, std::string_view real, std::optional<double> tolerance,
                 Retrials& retrials);

// The lines on which the two texts differ, in order: the shortest edit between them. Empty when the
// output is as stated. White space at a line's end and at the text's end does not count.
std::vector<DiffLine> output_changes(std::string_view stated, std::string_view real,
                                     std::optional<double> tolerance, Retrials& retrials);

}  // namespace mjcourse
