#include "lesson/blocks/read_chart.h"

#include <utility>

#include "lesson/json/chart_vocabulary.h"
#include "lesson/json/json_object.h"

namespace mjcourse {
namespace {

constexpr const char* kDataCure = "write \"data\": {\"name\": \"EXAMPLE/TABLE\"}";

// {"name": "EXAMPLE/TABLE"}
void read_data(const JsonValue& value, Reading& reading, Chart& chart) {
  JsonObject data(value, words::kChartData, reading);
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
  chart.example = name.part(0, slash);
  chart.table = name.part(slash + 1, name.text.size());
}

}  // namespace

std::optional<Chart> read_chart(Fence& fence, LessonReader& reader) {
  Reading& reading = reader.reading();
  fence.finish("plot", {}, reading);
  std::optional<JsonValue> json = parse_json(fence.body(), reading);
  if (!json) return std::nullopt;
  JsonObject object(*json, words::kChart, reading);
  if (!object.is_object()) return std::nullopt;
  Chart chart;
  chart.span = fence.span();
  if (const JsonValue* data = object.require("data", "this plot has no \"data\"", kDataCure)) {
    read_data(*data, reading, chart);
  }
  chart.caption = reader.fragment(object.string("caption"));
  chart.alt = object.string("alt").text;
  object.finish();
  chart.json = fence.body().text;
  chart.tree = *std::move(json);
  return chart;
}

}  // namespace mjcourse
