#include "evaluate/programs/compiled_recipe.h"

#include "evaluate/context/recipe.h"

namespace mjcourse {

Dependencies compiled_recipe(const RunContext& run_context, const std::string& kind,
                             const std::vector<std::string>& text, bool optimize) {
  Dependencies recipe = recipe_of(run_context, kind, text);
  const auto& compiler = run_context.compiler();
  if (!compiler) {
    recipe.push_back({"compiler", kAbsent});
    return recipe;
  }
  recipe.push_back({"compiler", compiler->toolchain().full_version});
  recipe.push_back({"linker", compiler->toolchain().linker});
  recipe.push_back({"flags", compile_flags(optimize)});
  return recipe;
}

Dependencies with_page(Dependencies recipe, const RunContext& run_context) {
  const PageToolchain* page = run_context.page();
  recipe.push_back({"page", page == nullptr ? kAbsent : page->version()});
  return recipe;
}

}  // namespace mjcourse
