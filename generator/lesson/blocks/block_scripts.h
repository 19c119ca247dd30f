// What a block has of scripts and expressions over `model` and `data`.
#pragma once

#include <vector>

#include "lesson/blocks/block.h"

namespace mjcourse {

// In the block's order, without those that are empty; they live as long as the block. Where the
// name of an example's result may stand instead, it counts as one.
std::vector<const LocatedText*> scripts_of(const Block& block);

}  // namespace mjcourse
