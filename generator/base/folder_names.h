// The names in a folder that is open, whatever its path leads to meanwhile.
// Tested by tests/generator/base/remove_folder_test.cpp.
#pragma once

#include <string>
#include <vector>

namespace mjcourse {

// All but `.` and `..`; none where they cannot be read.
std::vector<std::string> names_in_folder(int folder);

}  // namespace mjcourse
