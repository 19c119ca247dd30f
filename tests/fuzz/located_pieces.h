// All that a block took out of its lesson: texts and spans.
#pragma once

#include <vector>

#include "lesson/blocks/block.h"

namespace mjcourse {

struct LocatedPieces {
  std::vector<const LocatedText*> texts;
  std::vector<const LocatedText*> bodies;  // texts whose bytes are the lesson's own
  std::vector<Span> spans;
};

// They point into `block`.
LocatedPieces pieces_of(const Block& block);

}  // namespace mjcourse
