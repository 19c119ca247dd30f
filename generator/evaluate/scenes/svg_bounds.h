// How much an SVG may hold to be read at all. It is read in the generator's own process, and the
// XML library keeps all attributes of an element at once, each in several times the memory of its
// text.
#pragma once

#include <optional>
#include <string>

#include "evaluate/scenes/svg_faults.h"

namespace mjcourse {

// What is too much of `bytes`, where it begins; found by reading them once.
std::optional<SvgFault> excess_of_svg(const std::string& bytes);

}  // namespace mjcourse
