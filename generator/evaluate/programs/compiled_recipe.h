// What a task depends on that compiles: the recipe as it is known before.
// Tested by tests/store/dependencies.mjs.
#pragma once

#include <string>
#include <vector>

#include "cache/dependency.h"
#include "evaluate/context/run_context.h"

namespace mjcourse {

// As recipe_of (recipe.h), with the compiler, the linker and their flags.
Dependencies compiled_recipe(const RunContext& run_context, const std::string& kind,
                             const std::vector<std::string>& text, bool optimize);

// The same of what a page makes of it, with the page's compiler and engine.
Dependencies with_page(Dependencies recipe, const RunContext& run_context);

}  // namespace mjcourse
