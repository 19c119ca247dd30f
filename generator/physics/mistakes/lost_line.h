// Where a mistake stands of which MuJoCo tells no line: in an included file, in a keyframe, in
// a sensor, among the actuators, in the size of its stack.
// Tested by tests/generator/physics/mistakes/model_error_test.cpp.
#pragma once

#include <functional>
#include <string>

#include "physics/mistakes/model_error.h"
#include "physics/mistakes/whole_mjcf.h"

namespace mjcourse {

// `error` with its file and line where they can be found in `whole`, and as it was otherwise.
// `load` gives what MuJoCo says of a text in place of the model's.
ModelError with_line(ModelError error, const WholeMjcf& whole,
                     const std::function<ModelError(const std::string& mjcf)>& load);

}  // namespace mjcourse
