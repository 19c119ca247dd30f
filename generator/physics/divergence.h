// Which entry of the state stopped being a sane number.
//
// MuJoCo checks qpos, qvel and qacc before and within each step; when an entry is not a number or
// beyond mjMAXVAL it notes which, resets the data and goes on. We look at its notes, and at the
// state itself by the same measure.
// Tested by tests/generator/physics/simulation_test.cpp.
#pragma once

#include <optional>
#include <string>

#include "physics/data.h"
#include "physics/model.h"

namespace mjcourse {

// "qpos[3] of joint `free`"; nothing while all is well.
std::optional<std::string> find_divergence(const Model& model, const Data& data);

}  // namespace mjcourse
