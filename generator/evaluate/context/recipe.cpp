#include "evaluate/context/recipe.h"

#include <mujoco/mujoco.h>

#include "base/arithmetic.h"
#include "base/sha256.h"
#include "process/loaded_libraries.h"
#include "sources/kEvaluateSources.h"

namespace mjcourse {

Dependencies recipe_of(const RunContext& run_context, const std::string& kind,
                       const std::vector<std::string>& text,
                       const std::vector<std::string>& scripts) {
  Sha256 hash;
  for (const std::string& part : text) hash.add(part);
  Dependencies recipe{{"kind", kind},
                      {"text", hash.hex()},
                      {"mjcourse", std::string("sources ") + kEvaluateSources},
                      {"MuJoCo", mj_versionString()},
                      {"libraries", loaded_libraries()},
                      {"arithmetic", arithmetic()}};
  for (const std::string& script : scripts) {
    recipe.push_back({"script/" + script + ".js", run_context.script_hash(script)});
  }
  return recipe;
}

Dependencies with_drawing(Dependencies recipe) {
  recipe.push_back({"processor", processor_features()});
  return recipe;
}

}  // namespace mjcourse
