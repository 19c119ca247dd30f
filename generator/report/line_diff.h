// What changed between two texts, line by line: the shortest edit from the one to the other.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace mjcourse {

struct DiffLine {
  enum class Kind { gone, come };
  Kind kind;
  int line;  // from 1, of the text before; of a line that comes, the one that it stands before
  std::string text;
};

// Is this line of the text before the same as that one behind?
using SameLine = std::function<bool(std::string_view before, std::string_view after)>;

// The lines on which the two texts differ, in order; empty when they are the same. Texts that share
// no more than their ends, and are so long that the search would take seconds, differ in all of the
// lines between.
std::vector<DiffLine> line_diff(std::vector<std::string_view> before,
                                std::vector<std::string_view> after, const SameLine& same);

}  // namespace mjcourse
