// MuJoCo's functions as the native half of the world gives them (site/press/script/native.ts):
// without the model and the data among the arguments, arrays as Float64Array, nothing checked. The
// strict half (site/press/script/mujoco-functions.ts) checks before it calls.
#pragma once

#include "script/javascriptcore.h"

namespace mjcourse {

class Simulation;

// An object with a function for each name; `simulation` must outlive it.
JSObjectRef make_mujoco_functions(JSContextRef context, Simulation& simulation);

}  // namespace mjcourse
