// The files of a lab's model: what the page must get to compile it.
#pragma once

#include <optional>

#include "evaluate/scenes/lab_context.h"
#include "findings/result.h"

namespace mjcourse {

// The lab's model, which compiles. Nothing (reported) where the page could not compile it.
std::optional<LabModel> find_lab_model(const LabContext& context);

}  // namespace mjcourse
