// What a block has of scripts and expressions over `model` and `data`.
#pragma once

#include <vector>

#include "lesson/blocks/block.h"

namespace mjcourse {

// A script runs; a value is an expression that is read, and an assignment one that is set as well.
// Definitions declare names for the scripts and values of their block.
enum class ScriptKind { script, value, assignment, definitions };

struct BlockScript {
  const LocatedText* text;
  ScriptKind kind;
};

// In the block's order, without those that are empty; they live as long as the block. Where the
// name of an example's result may stand instead, it counts as one.
std::vector<BlockScript> scripts_of(const Block& block);
std::vector<BlockScript> scripts_of(const Lab& lab);

}  // namespace mjcourse
