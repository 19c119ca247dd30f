// How many steps simulated time takes.
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "physics/model.h"

namespace mjcourse {

inline constexpr int kMostSteps = 1'000'000;  // in one go

// The steps that come nearest to `seconds`, or why these are too many: "the time step is …".
tl::expected<int, std::string> step_count(const Model& model, double seconds);

}  // namespace mjcourse
