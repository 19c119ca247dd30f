// How labs and figures are seen, and the pictures of that.
// Tested by tests/generator/evaluate/scenes/lab_test.cpp.
#pragma once

#include <optional>
#include <vector>

#include "evaluate/context/block_context.h"
#include "findings/result.h"
#include "physics/overlays.h"
#include "physics/whole_view.h"

namespace mjcourse {

struct View {
  Lab::Camera camera;
  std::vector<Lab::Overlay> overlays;
  int width = 0, height = 0;  // CSS pixels
  Detail detail = Detail::still;
};

// Report the names that are no overlay of MuJoCo's.
void check_overlays(const std::vector<LocatedText>& names, const BlockContext& context);
std::vector<LocatedText> names_of(const std::vector<Lab::Overlay>& overlays);
Overlays switched(const std::vector<Lab::Overlay>& overlays);

// Without one of the author's, all of the model is seen.
Lab::Camera camera_of(const std::optional<Lab::Camera>& camera, const WholeView& view);

// Nothing (reported at `blamed`) where it cannot be drawn; `what` names it: "the poster".
std::optional<Picture> draw(const Simulation& simulation, const View& view, const std::string& what,
                            Span blamed, const BlockContext& context);

Poster poster_of(const Picture& picture, const View& view);

}  // namespace mjcourse
