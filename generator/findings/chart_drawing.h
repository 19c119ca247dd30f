// A plot as it was drawn: SVG for a page's text, and for a phone.
#pragma once

#include <optional>
#include <string>

namespace mjcourse {

struct ChartDrawing {
  std::string svg;  // what stands inside of an <svg> of this size
  int width = 0, height = 0;
};

struct ChartDrawings {
  ChartDrawing wide;
  std::optional<ChartDrawing> narrow;  // for phones, where the wide one cannot serve them
};

}  // namespace mjcourse
