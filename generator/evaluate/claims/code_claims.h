// The claims of programs, and of what a lesson shows of them.
// Tested by tests/generator/evaluate/claims/claims_test.cpp.
#pragma once

#include <cstddef>

#include "evaluate/claims/claim_context.h"

namespace mjcourse {

// `i` is the index of the block; its claims join those of the context.
void claim(const Example& example, std::size_t i, ClaimContext& context);
void claim(const Exercise& exercise, std::size_t i, ClaimContext& context);
void claim(const Snippet& snippet, std::size_t i, ClaimContext& context);
void claim(const Commands& commands, std::size_t i, ClaimContext& context);
void claim(const Output& output, std::size_t i, ClaimContext& context);
void claim(const Unchecked& unchecked, std::size_t i, ClaimContext& context);

}  // namespace mjcourse
