// All of a fence, of which a block keeps only how it opens.
#pragma once

#include "base/source_text.h"

namespace mjcourse {

// From `opening` to the end of the line that closes the fence, or of the lesson.
Span fence_extent(const SourceText& lesson, Span opening);

}  // namespace mjcourse
