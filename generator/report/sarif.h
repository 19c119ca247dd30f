// Diagnostics as SARIF 2.1.0, the format in which tools that look at sources tell what they found
// (OASIS, Static Analysis Results Interchange Format; sections are cited as §).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "report/diagnostic.h"

namespace mjcourse {

// `folder` is the course's, relative to the repository; `version` is mjcourse's.
nlohmann::json sarif_log(const Diagnostics& diagnostics, const std::string& folder,
                         const std::string& version);

}  // namespace mjcourse
