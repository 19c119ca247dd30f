// The elements and attributes of SVG that draw.
// Tested by tests/generator/evaluate/scenes/svg_faults_test.cpp.
#pragma once

#include <string_view>

namespace mjcourse {

bool is_svg_element(std::string_view name);
// In any of them; what it says is looked at elsewhere.
bool is_svg_attribute(std::string_view name);

}  // namespace mjcourse
