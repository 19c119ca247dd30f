// A control of a lab: a button, a slider, a toggle, a select, a keyframe.
#pragma once

#include <optional>

#include "lesson/blocks/lab.h"
#include "lesson/json/json_object.h"

namespace mjcourse {

// Nothing when there is no such control, or when it could do nothing.
std::optional<Lab::Control> read_control(const JsonValue& value, Reading& reading);

}  // namespace mjcourse
