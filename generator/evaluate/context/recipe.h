// Recipes: what results depend on as is known before the work.
// Tested by tests/generator/evaluate/evaluate_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "cache/dependency.h"
#include "evaluate/context/run_context.h"

namespace mjcourse {

// `kind` is what is made, `text` all that the lesson says of it, `scripts` the bundles that work on
// it. Beside these stand the versions of mjcourse, of MuJoCo and of the system's libraries, and how
// they round.
Dependencies recipe_of(const RunContext& run_context, const std::string& kind,
                       const std::vector<std::string>& text,
                       const std::vector<std::string>& scripts = {});

// With what the processor has, which decides how the libraries that draw compute.
Dependencies with_drawing(Dependencies recipe);

}  // namespace mjcourse
