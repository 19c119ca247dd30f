// A question's "verify": how the build finds its answer, or why it does not.
#pragma once

#include <optional>

#include "lesson/blocks/quiz.h"
#include "lesson/json/json_value.h"

namespace mjcourse {

// Nothing when it does not say what to do.
std::optional<Proof> read_proof(const JsonValue& value, const Question& question, Reading& reading);

}  // namespace mjcourse
