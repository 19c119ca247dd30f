// Numbers that no model should have: infinite ones, and those that are none. MuJoCo takes them from
// MJCF, and lets the simulation diverge.
#pragma once

#include <string>

#include "physics/model.h"

namespace mjcourse {

// The first of the model's fields that has one, as "body_pos[3]"; "" for none.
std::string find_infinite_field(Model& model);

}  // namespace mjcourse
