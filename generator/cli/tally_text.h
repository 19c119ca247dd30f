// What was verified, in a line: "3 programs run, 3 outputs compared, 1 lab rehearsed".
#pragma once

#include <cstddef>
#include <string>

#include "findings/tally.h"

namespace mjcourse {

// "" where nothing was verified.
std::string tally_text(const Tally& tally);

// The same for a reader who must not take a failure for a lesson of prose.
std::string outcome_text(const Tally& tally, std::ptrdiff_t errors);

}  // namespace mjcourse
