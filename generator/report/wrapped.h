// A sentence set into lines of a terminal.
#pragma once

#include <string>
#include <string_view>

namespace mjcourse {

// `text`, which is one line, broken at blanks so that no line is wider than `width` columns. What
// is longer than a line by itself stays whole, and so does code in backticks where a line can hold
// it. The first line goes on at column `at`, and each that follows begins with `indent` blanks.
std::string wrapped(std::string_view text, int width, int indent, int at = 0);

}  // namespace mjcourse
