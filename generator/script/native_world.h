// The native half of a world, over a simulation: the object that site/press/script/native.ts
// describes, with tables (site/press/script/field-table.ts) in the place of fields.
// Tested by tests/generator/script/lookups_test.cpp.
// Tested by tests/generator/script/strict_array_test.cpp.
#pragma once

#include "script/javascriptcore.h"

namespace mjcourse {

class Simulation;

// Its fields are views on the memory of the simulation's model and data, which must outlive it.
JSObjectRef make_native_world(JSContextRef context, Simulation& simulation);

}  // namespace mjcourse
