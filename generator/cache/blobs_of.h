// The pictures and films in a finding.
#pragma once

#include <vector>

#include "findings/finding.h"

namespace mjcourse {

// Some may be empty.
std::vector<Blob*> blobs_of(Finding& finding);

}  // namespace mjcourse
