// The claims of what a reader looks at, plays with and answers.
// Tested by tests/generator/evaluate/claims/claims_test.cpp.
#pragma once

#include <cstddef>

#include "evaluate/claims/claim_context.h"

namespace mjcourse {

// `i` is the index of the block; its claims join those of the context.
void claim(const ModelExcerpt& excerpt, std::size_t i, ClaimContext& context);
void claim(const InlineModel& model, std::size_t i, ClaimContext& context);
void claim(const Lab& lab, std::size_t i, ClaimContext& context);
void claim(const Figure& figure, std::size_t i, ClaimContext& context);
void claim(const Plot& plot, std::size_t i, ClaimContext& context);
void claim(const Image& image, std::size_t i, ClaimContext& context);
void claim(const Quiz& quiz, std::size_t i, ClaimContext& context);

}  // namespace mjcourse
