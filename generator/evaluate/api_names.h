// All names of MuJoCo's C interface, for the completion of a program that a reader edits.
// Tested by tests/generator/evaluate/api_names_test.cpp.
#pragma once

#include <nlohmann/json.hpp>

#include "physics/mujoco_api.h"

namespace mjcourse {

// [[name, kind, declaration, comment], …], in the order of the names. A field's name is
// "mjModel.nq", a kind one of "function", "type", "constant", "variable", "property".
nlohmann::json api_names(const MujocoApi& api);

}  // namespace mjcourse
