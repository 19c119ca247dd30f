// What a compiled program depends on: the recipe as it is known before, and the files that the
// compiler read and the program opened.
// Tested by tests/store/dependencies.mjs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cache/dependency.h"
#include "evaluate/context/worker_context.h"
#include "process/subprocess.h"
#include "toolchain/compiler.h"

namespace mjcourse {

// As recipe_of (recipe.h), with the compiler, the linker and their flags.
Dependencies compiled_recipe(const RunContext& run_context, const std::string& kind,
                             const std::vector<std::string>& text, bool optimize);

// With the compiler and the engine of the page, which run the program again.
Dependencies with_page(Dependencies recipe, const RunContext& run_context);

// The folder of `source` is where the compiler worked, `folder` where the program did; of these
// nothing is traced.
void trace_compilation(const Compiled& compiled, const std::filesystem::path& source,
                       WorkerContext& worker_context);
void trace_run(const Outcome& outcome, const std::filesystem::path& folder,
               WorkerContext& worker_context);

}  // namespace mjcourse
