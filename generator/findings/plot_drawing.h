// A plot as it was drawn: SVG for a page's text, and for a phone.
#pragma once

#include <optional>
#include <string>

namespace mjcourse {

struct PlotDrawing {
  std::string svg;  // what stands inside of an <svg> of this size
  int width = 0, height = 0;
};

struct PlotDrawings {
  PlotDrawing wide;
  std::optional<PlotDrawing> narrow;  // for phones, where the wide one cannot serve them
};

}  // namespace mjcourse
