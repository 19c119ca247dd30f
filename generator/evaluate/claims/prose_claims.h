// The claims of the text itself: values, formulas and established facts.
// Tested by tests/generator/evaluate/claims/claims_test.cpp.
#pragma once

#include <cstddef>

#include "evaluate/claims/claim_context.h"

namespace mjcourse {

// `i` is the index of the block; its claims join those of the context.
void claim(const InlineValue& value, std::size_t i, ClaimContext& context);
void claim(const Math& math, std::size_t i, ClaimContext& context);
void claim(const Callout& callout, std::size_t i, ClaimContext& context);

}  // namespace mjcourse
