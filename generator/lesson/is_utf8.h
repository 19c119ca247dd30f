// Whatever an author writes is UTF-8.
#pragma once

#include <string>

#include "report/diagnostic.h"

namespace mjcourse {

// False (reported, at the first byte that is not) when the file `path` is something else.
bool is_utf8(const std::string& path, const std::string& bytes, Diagnostics& diagnostics);

}  // namespace mjcourse
