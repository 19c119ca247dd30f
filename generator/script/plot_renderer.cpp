#include "script/plot_renderer.h"

#include <utility>

#include "script/js_value.h"

namespace mjcourse {
namespace {

using nlohmann::json;

// Vega's memory grows with each plot, so now and then it is begun anew.
constexpr int kPlotsOfAnEngine = 32;

// Long enough that a drawing that fills its worker's memory meets that limit first, even where the
// kernel hands out memory slowly.
constexpr double kDrawingSeconds = 30;

PlotDrawing drawing_of(const json& data) {
  return {data.at("svg"), data.at("width"), data.at("height")};
}

// What kept the engine from an answer.
PlotFault fault_of(const ScriptError& error) {
  if (error.id != "E-script-time") return {"E-plot-spec", error.message, "", json::array()};
  return {"E-plot-size", "the drawing of this plot " + error.message,
          "let it show fewer rows, bins or parts, or make them in the example", json::array()};
}

PlotFault fault_of(const json& data) {
  return {data.at("id"),  data.at("message"), data.at("cure"), data.at("path"),
          data.at("key"), data.at("from"),    data.at("to")};
}

}  // namespace

tl::expected<PlotDrawings, std::vector<PlotFault>> PlotRenderer::draw(const std::string& spec,
                                                                      const json& table,
                                                                      const std::string& id) {
  if (!engine_ || ++drawn_ > kPlotsOfAnEngine) {
    engine_.emplace(kDrawingSeconds);
    engine_->load(bundle_, "plot.js");
    drawn_ = 1;
  }
  const auto begun = engine_->call("draw", {spec, table.is_null() ? "" : table.dump(), id});
  const auto answer = begun ? engine_->call("drawn", {}) : begun;
  if (!answer) return tl::unexpected(std::vector{fault_of(answer.error())});
  const json result = json_of(*answer);
  if (const auto faults = result.find("faults"); faults != result.end()) {
    std::vector<PlotFault> found;
    for (const json& fault : *faults) found.push_back(fault_of(fault));
    return tl::unexpected(std::move(found));
  }
  PlotDrawings drawings{drawing_of(result.at("wide")), std::nullopt};
  if (const json& narrow = result.at("narrow"); !narrow.is_null()) {
    drawings.narrow = drawing_of(narrow);
  }
  return drawings;
}

}  // namespace mjcourse
