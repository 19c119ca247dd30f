// Which of several Debian packages this system's release has.
#pragma once

#include <string>
#include <vector>

namespace mjcourse {

// The first of `names` that apt knows; the first of all where it knows none, or is not there.
std::string known_package(const std::vector<std::string>& names);

}  // namespace mjcourse
