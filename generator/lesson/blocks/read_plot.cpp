#include "lesson/blocks/read_plot.h"

#include <utility>

#include "lesson/json/json_object.h"
#include "lesson/json/plot_vocabulary.h"

namespace mjcourse {
namespace {

constexpr const char* kDataCure = "write \"data\": {\"name\": \"EXAMPLE/TABLE\"}";

// {"name": "EXAMPLE/TABLE"}
void read_data(const JsonValue& value, Reading& reading, Plot& plot) {
  JsonObject data(value, words::kPlotData, reading);
  // What Vega-Lite takes as well.
  for (const char* other : {"url", "values", "sequence", "sphere", "graticule", "format"}) {
    const JsonValue* found = data.misplaced(other);
    if (found == nullptr) continue;
    reading.error("E-plot-data", found->span,
                  "a plot shows a table that an example of the course reported, and no other data",
                  kDataCure);
    return;
  }
  const LocatedText name = data.string("name");
  data.finish();
  if (name.text.empty()) return;
  const std::size_t slash = name.text.find('/');
  if (slash == std::string::npos || slash == 0 || slash + 1 == name.text.size()) {
    reading.error("E-plot-data", name.span(), "this does not name a table of an example",
                  kDataCure);
    return;
  }
  plot.example = name.part(0, slash);
  plot.table = name.part(slash + 1, name.text.size());
}

}  // namespace

std::optional<Plot> read_plot(Fence& fence, LessonReader& reader) {
  Reading& reading = reader.reading();
  fence.finish("plot", {}, reading);
  std::optional<JsonValue> json = parse_json(fence.body(), reading);
  if (!json) return std::nullopt;
  JsonObject object(*json, words::kPlot, reading);
  if (!object.is_object()) return std::nullopt;
  Plot plot;
  plot.span = fence.span();
  if (const JsonValue* data = object.require("data", "this plot has no \"data\"", kDataCure)) {
    read_data(*data, reading, plot);
  }
  plot.caption = reader.fragment(object.string("caption"));
  plot.alt = object.string("alt").text;
  object.finish();
  plot.json = fence.body().text;
  plot.tree = *std::move(json);
  return plot;
}

}  // namespace mjcourse
