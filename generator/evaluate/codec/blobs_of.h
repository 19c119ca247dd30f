// The pictures and films in a finding.
// Tested by tests/generator/evaluate/codec/result_codec_test.cpp.
#pragma once

#include <vector>

#include "findings/finding.h"

namespace mjcourse {

// Some may be empty.
std::vector<Blob*> blobs_of(Finding& finding);

}  // namespace mjcourse
