// The colours of a terminal: never the only bearer of a meaning.
#pragma once

#include <string_view>

namespace mjcourse {

inline constexpr std::string_view kBold = "\033[1m";
inline constexpr std::string_view kRed = "\033[1;31m";
inline constexpr std::string_view kYellow = "\033[1;33m";
inline constexpr std::string_view kGreen = "\033[1;32m";
inline constexpr std::string_view kPlain = "\033[0m";

// Does the reader of `descriptor` want them? On a terminal, unless NO_COLOR says otherwise
// (no-color.org), or TERM that it knows none.
bool wants_colours(int descriptor);

}  // namespace mjcourse
