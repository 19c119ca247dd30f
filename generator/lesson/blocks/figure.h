// ```figure: a picture of a simulation in a state, or what it does from there on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lesson/blocks/lab.h"
#include "lesson/syntax/located_text.h"
#include "lesson/syntax/markdown.h"

namespace mjcourse {

struct Figure {
  struct Snapshot {  // a state that an example recorded
    LocatedText example, name;
  };
  struct Animation {
    double seconds = 0;  // simulated, and as long in the page
    int rate = 30;       // frames a second
    Span span;           // its object

    int frames() const;
  };

  LocatedText model;  // a name, or MJCF where it starts with `<`
  std::optional<Lab::Camera> camera;
  std::vector<Lab::Overlay> overlays;
  // The state: the model's own or a keyframe's, a script run on it, and time that passes …
  LocatedText keyframe, run;
  double seconds = 0;
  Span seconds_span;
  std::optional<Snapshot> from;   // … or this
  int width = 640, height = 400;  // CSS pixels
  std::optional<Animation> animation;
  Document caption;
  std::string alt;
  LocatedText pin;  // the name of its reference picture; empty for none
  Span span;        // the opening fence
};

}  // namespace mjcourse
