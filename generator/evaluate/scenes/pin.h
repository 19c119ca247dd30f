// Pinned pictures: what is drawn, held against a small reference picture beside the lesson.
//
// A reviewer of a change of the course sees such a picture change with it, and a change that nobody
// meant is an error. References are PNG, about 160 pixels wide; `mjcourse accept` writes them.
#pragma once

#include <optional>
#include <vector>

#include "evaluate/context/block_context.h"
#include "findings/result.h"

namespace mjcourse {

// What came of holding `picture` against the reference named `pin`; nothing where none is named.
// A reference that is not there, cannot be read, or is not like `picture`, is reported.
std::optional<PinComparison> compare_pin(const LocatedText& pin, const Picture& picture,
                                         const BlockContext& context);

}  // namespace mjcourse
