// Finding out with which versions everything is found out.
// Tested by tests/generator/evaluate/claims/claims_test.cpp.
#pragma once

#include "base/files.h"
#include "findings/versions.h"

namespace mjcourse {

// All but the compiler's, which is asked for its own; `assets` holds what the site's build made.
Versions known_versions(const Files& assets);

}  // namespace mjcourse
