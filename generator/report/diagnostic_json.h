// Diagnostics as JSON, for tools that read reports; site/browser/report/verification.ts has its
// shape.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "report/diagnostic.h"

namespace mjcourse {

nlohmann::json json_of(const Diagnostic& diagnostic);

}  // namespace mjcourse
