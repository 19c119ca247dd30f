// A diff that a person understands at a glance.
//
//     21 - nq 7 nv 7
//        + nq 7 nv 6
//                  ^
//     23 - norm 1.0000
//   line 24 moved above line 20
//
// A line that changed stands beside what it became, with the words marked that are new; a line that
// moved is named; what is long is folded in the middle.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/line_diff.h"

namespace mjcourse {

struct DiffStyle {
  bool colours = false;  // ANSI, beside the signs
  std::size_t most_rows = 24;
};

// `lines` as line_diff gives them; `same` tells which of them only moved.
std::string diff_text(const std::vector<DiffLine>& lines, const SameLine& same,
                      const DiffStyle& style = {});

}  // namespace mjcourse
