// C++ functions that scripts call.
// Tested by tests/generator/script/mujoco_functions_test.cpp.
#pragma once

#include <functional>
#include <span>

#include "script/javascriptcore.h"

namespace mjcourse {

using NativeFunction =
    std::function<JSValueRef(JSContextRef context, std::span<const JSValueRef> arguments)>;

// A JavaScript function that calls `function` and owns it. No C++ exception may cross
// JavaScriptCore's frames, so one becomes a JavaScript Error with its text and, as scripts come to
// C++ for MuJoCo's sake, with the id "E-script-mujoco".
JSObjectRef make_function(JSContextRef context, NativeFunction function);

}  // namespace mjcourse
