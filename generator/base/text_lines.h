// Texts taken apart into lines.
#pragma once

#include <string_view>
#include <vector>

namespace mjcourse {

// The lines of `text` without their ends, "\n" or "\r\n"; an end begins no line of its own.
std::vector<std::string_view> lines_of(std::string_view text);

// `line` without the blanks, tabs and carriage returns at both of its ends.
std::string_view trimmed(std::string_view line);

}  // namespace mjcourse
