// The items of a question in the order in which they are shown: mixed, and the same in every build.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace mjcourse {

// The indices 0 … count - 1, two or more of them, in an order that only `seed` decides and that is
// never their own.
std::vector<std::size_t> shuffled(std::size_t count, std::string_view seed);

}  // namespace mjcourse
