// What labs and figures have in common: how they are seen, and the reference picture that holds
// them to it.
// Tested by tests/generator/lesson/blocks/read_figure_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lesson/blocks/block.h"
#include "lesson/json/json_object.h"

namespace mjcourse {

std::optional<Lab::Camera> read_camera(JsonObject& object, Reading& reading);
std::vector<Lab::Overlay> read_overlays(JsonObject& object, Reading& reading);

// What is to be seen, in words. A picture that says nothing to those who cannot see it is none of a
// lesson's: blanks are an error.
std::string read_alt(JsonObject& object, Reading& reading);

// The name of the reference picture; empty where there is none, or its name is no name (reported).
LocatedText read_pin(JsonObject& object, Reading& reading);

// The same of a block that was read; empty for what is not drawn.
LocatedText pin_of(const Block& block);

}  // namespace mjcourse
