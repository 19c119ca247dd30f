// MuJoCo's objects are named by a type and an id; this says where the ids end.
// Tested by tests/generator/physics/model_test.cpp.
#pragma once

#include <mujoco/mujoco.h>

namespace mjcourse {

// How many objects of `type` the model has; 0 for types whose objects have no names.
int object_count(const mjModel& model, mjtObj type);

}  // namespace mjcourse
