// Diagnostics as GitHub shows them beside the changed lines: the workflow commands `::error` and
// `::warning`, one line each.
#pragma once

#include <string>

#include "report/diagnostic.h"

namespace mjcourse {

// Ends in a newline, unless there is none. `folder` is the course's, relative to the repository.
std::string github_annotations(const Diagnostics& diagnostics, const std::string& folder);

}  // namespace mjcourse
