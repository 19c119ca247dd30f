// Which libraries a lesson's program is linked with.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mjcourse {

// Does it draw without a screen: does it include <GL/osmesa.h>?
bool draws(std::string_view program);

// Their names, as they stand behind -l: MuJoCo, and OSMesa where the program draws.
std::vector<std::string> linked_libraries(std::string_view program);

}  // namespace mjcourse
