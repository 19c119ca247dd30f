// PlotRenderer: Vega-Lite specs to SVG, by Vega.
//
// Enter with draw(). The drawing names colours and faces as the site's styles do (`var(--data-1)`),
// so it serves light and dark. Whatever Vega or Vega-Lite doubt is a fault, and so is what they
// would pass over: words that they do not know, columns that are not there, numbers that are none.
// What was drawn before changes nothing of a drawing.
// Tested by tests/generator/script/plot_renderer_test.cpp.
// Tested by tests/generator/script/plot_gallery_test.cpp.
// Tested by tests/generator/script/plot_limits_test.cpp.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "findings/plot_drawing.h"
#include "script/engine.h"

namespace mjcourse {

struct PlotFault {
  std::string id, message, cure;
  nlohmann::json path;  // keys and indices, from the outside in; empty for the plot as a whole
  bool key = false;     // the path's last key is what is wrong, not its value
  std::size_t from = 0, to = 0;  // the bytes of a string that are wrong; none for all of it
};

class PlotRenderer {
 public:
  // `bundle` is the text of script/plot.js.
  explicit PlotRenderer(std::string bundle) : bundle_(std::move(bundle)) {}

  // `spec` is the fence's JSON; `table` a list of pairs, each a column's name and its numbers, or
  // null to look at the spec's words alone, which draws nothing. `id` begins all ids inside.
  tl::expected<PlotDrawings, std::vector<PlotFault>> draw(const std::string& spec,
                                                          const nlohmann::json& table,
                                                          const std::string& id);

 private:
  std::string bundle_;
  std::optional<Engine> engine_;
  int drawn_ = 0;  // by this engine
};

}  // namespace mjcourse
