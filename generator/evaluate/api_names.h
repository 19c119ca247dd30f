// All names of MuJoCo's C interface, for the completion of a program that a reader edits.
// Tested by tests/generator/evaluate/api_names_test.cpp.
#pragma once

#include <string>

#include "physics/mujoco_api.h"

namespace mjcourse {

// JSON: [[name, kind, declaration, comment], …], in the order of the names. A field's name is
// "mjModel.nq", a kind one of "function", "type", "constant", "variable", "property".
std::string api_names(const MujocoApi& api);

}  // namespace mjcourse
