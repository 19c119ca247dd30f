// MuJoCo's names in the code of a lesson: which functions, types, constants and fields a program or
// a script uses, and in which lines.
//
// Functions, types and constants are told by their names, which all begin with `mj`. A field is one
// of the structure that its object is. What that is, the program's declaration says (`const
// mjContact& contact`, `Data now`), or a name that everybody gives it (`model`, `data`). A chain is
// followed (`model->opt.timestep`). Behind an arrow, the field itself says it where only one of the
// two large structures has it. What stays in doubt is left out; comments and strings are passed
// over. C++ and JavaScript have all of this in common.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "physics/mujoco_api.h"

namespace mjcourse {

// The lines, from 1, that use each name of `api`: "mj_step", "mjData.qpos", "mjJNT_FREE".
using CodeNames = std::map<std::string, std::set<int>>;

CodeNames names_in_code(std::string_view code, const MujocoApi& api);

}  // namespace mjcourse
