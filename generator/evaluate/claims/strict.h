// What `check --strict` does not let pass: whatever nobody proved and nobody gave a reason for.
// Tested by tests/generator/evaluate/claims/claims_test.cpp.
#pragma once

#include "findings/claim.h"

namespace mjcourse {

// An error for each claim that is asserted or unchecked without a reason.
Diagnostics unreasoned(const Claims& claims);

}  // namespace mjcourse
