// Is one text an excerpt of another, line by line?
//
// Indentation and blank lines do not count. A line of the excerpt that is `…`, or a comment that
// holds one, stands for any lines; what stands between two of these must be together in the whole.
#pragma once

#include <optional>
#include <string_view>

namespace mjcourse {

// Lines count from 1; `whole` is 0 where nothing there is like the excerpt's line.
struct ExcerptMismatch {
  int excerpt = 0;
  int whole = 0;
};

// The first line of the excerpt that is not where it should be, and what stands there instead, at
// the place of the whole that is most like the excerpt. Nothing when it is an excerpt.
std::optional<ExcerptMismatch> find_excerpt_mismatch(std::string_view excerpt,
                                                     std::string_view whole);

// Is this line of an excerpt one that stands for any others?
bool skips_lines(std::string_view line);

}  // namespace mjcourse
