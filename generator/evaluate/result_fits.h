// Whether a result that was found before can be shown in a block as it is now.
//
// Writing a block goes through its parts and those of its result together, so what a store or a
// former edition has of it must have the same parts.
#pragma once

#include <filesystem>

#include "evaluate/task.h"

namespace mjcourse {

bool fits(const Block& block, const Result& result);
bool fits(const Block& block, const LabResult& result);

// Is all of `finding` what `task` may find out, in a course in `root`? It then names no file
// outside of that, and no place of a site but its own.
bool fits(const Task& task, const Finding& finding, const std::filesystem::path& root);

}  // namespace mjcourse
