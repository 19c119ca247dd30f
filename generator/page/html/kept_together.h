// What a line's end may not part: a formula and the comma behind it, a number and its unit.
//
// A browser may break a line at both ends of every formula, as if it were a picture, and at every
// blank.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace mjcourse {

// How many bytes at the beginning of `text` belong to the formula or number right before it:
// " N m" of " N m, and then", "," of ", and then", none of " and then".
std::size_t kept_length(std::string_view text);

// Does a number with its unit stand in `text`?
bool has_units(std::string_view text);

// `text` with a no-break space between each number and its unit.
std::string with_kept_units(std::string_view text);

}  // namespace mjcourse
