// Overlays as a lesson asks for them: names, switched on or off.
#pragma once

#include <mujoco/mujoco.h>

#include <map>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace mjcourse {

// "joints" → true. What is not named stays as MuJoCo's default has it.
using Overlays = std::map<std::string, bool>;

// Every name there is.
std::vector<std::string> overlay_names();

// The options that show `overlays`, or what is wrong with them: an unknown name (with "did you
// mean"), or two kinds of frames or of labels, of which MuJoCo draws one.
tl::expected<mjvOption, std::string> visual_options(const Overlays& overlays);

// The names of those that are on in `option`, MuJoCo's defaults among them.
std::vector<std::string> overlays_in(const mjvOption& option);

}  // namespace mjcourse
