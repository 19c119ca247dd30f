// What a lab takes of the memory that the page's engine can have.
//
// The engine's memory is one block of at most 2 GiB (site/browser/engine/wasm/CMakeLists.txt), of
// which also what MuJoCo asks for and never touches takes its part. A model that the generator can
// bear may be too large for it, and a reader would only be told that it failed.
// Tested by tests/courses/lab.
#pragma once

#include <cstdint>
#include <optional>

#include "evaluate/scenes/lab_context.h"
#include "physics/simulation.h"

namespace mjcourse {

// Bytes that the lab takes of it; reports the lab's model where the page would have no room for it.
std::optional<std::uint64_t> memory_in_page(const LabContext& context,
                                            const Simulation& simulation);

}  // namespace mjcourse
