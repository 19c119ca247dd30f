// What is told of a file that a course names and that is never read (base/beneath.h).
// Tested by tests/system/links.mjs.
#pragma once

#include <string>

#include "base/beneath.h"
#include "report/diagnostic.h"

namespace mjcourse {

// `refusal` is what Files::refusal() says of `path`.
Diagnostic refused_file(Place place, const std::string& path, const FileRefusal& refusal);

}  // namespace mjcourse
