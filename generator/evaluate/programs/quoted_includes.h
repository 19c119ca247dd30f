// `#include "name.h"` of a program: what its reader's compiler looks for beside the program first.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mjcourse {

// The names, in their order; also those that a condition leaves out.
std::vector<std::string> quoted_includes(std::string_view program);

}  // namespace mjcourse
