#include "evaluate/scenes/keyframe.h"

#include "base/nearest.h"

namespace mjcourse {

bool reset_to(const LocatedText& keyframe, Simulation& simulation, const BlockContext& context) {
  const std::string& name = keyframe.text;
  return simulation.reset_to_keyframe(name) ||
         context.error("E-keyframe-unknown", keyframe.span(),
                       "the model has no keyframe \"" + name + "\"",
                       suggest(name, simulation.model().names(mjOBJ_KEY)));
}

}  // namespace mjcourse
