// Which libraries a lesson's program is linked with.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mjcourse {

// Their names, as they stand behind -l: MuJoCo, and OSMesa where the program includes
// <GL/osmesa.h> to draw without a screen.
std::vector<std::string> linked_libraries(std::string_view program);

}  // namespace mjcourse
