// Numbers as a lab shows them, in the build as in the page.
#pragma once

#include <string>

namespace mjcourse {

// `value` with `digits` after its point, and never "-0.0".
std::string fixed_number(double value, int digits);

}  // namespace mjcourse
