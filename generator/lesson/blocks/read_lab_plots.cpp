#include "lesson/blocks/read_lab_plots.h"

#include <string>
#include <utility>

#include "lesson/json/lab_vocabulary.h"

namespace mjcourse {
namespace {

Lab::Readout read_readout(const JsonValue& value, Reading& reading) {
  JsonObject object(value, words::kReadout, reading);
  Lab::Readout readout;
  readout.label = object.string("label");
  readout.expression = object.string("expr");
  readout.digits = object.whole("digits", readout.digits);
  readout.unit = object.string("unit").text;
  object.finish();
  return readout;
}

Lab::Readout read_trace(const JsonValue& value, Reading& reading) {
  JsonObject object(value, words::kTrace, reading);
  Lab::Readout trace;
  trace.label = object.string("label");
  trace.expression = object.string("expr");
  object.finish();
  return trace;
}

Lab::Plot read_lab_plot(const JsonValue& value, Reading& reading) {
  JsonObject object(value, words::kLabPlot, reading);
  Lab::Plot plot;
  plot.ylabel = object.string("ylabel").text;
  plot.window = object.number("window", plot.window);
  plot.ymin = object.optional_number("ymin");
  plot.ymax = object.optional_number("ymax");
  if (plot.ymin && plot.ymax && !(*plot.ymin < *plot.ymax)) {
    reading.error("E-json-range", object.find("ymax")->span,
                  "\"ymax\" is the upper end of the plot: more than \"ymin\"");
  }
  for (const JsonValue& value_of_trace :
       object.list("traces", "add a trace: {\"label\": …, \"expr\": …}")) {
    Lab::Readout trace = read_trace(value_of_trace, reading);
    if (!trace.expression.text.empty()) plot.traces.push_back(std::move(trace));
  }
  const auto most = static_cast<std::size_t>(words::kLabPlot.find("traces")->limits.most);
  if (plot.traces.size() > most) {
    reading.error("E-lab-plot", plot.traces[most].label.span(),
                  "a plot has colours for four traces", "put the others into a plot of their own");
  }
  object.finish();
  return plot;
}

}  // namespace

std::vector<Lab::Readout> read_readouts(JsonObject& lab, Reading& reading) {
  std::vector<Lab::Readout> readouts;
  for (const JsonValue& value : lab.list("readouts")) {
    Lab::Readout readout = read_readout(value, reading);
    if (!readout.expression.text.empty()) readouts.push_back(std::move(readout));
  }
  return readouts;
}

std::vector<Lab::Plot> read_lab_plots(JsonObject& lab, Reading& reading) {
  std::vector<Lab::Plot> plots;
  for (const JsonValue& value : lab.list("plots")) plots.push_back(read_lab_plot(value, reading));
  return plots;
}

}  // namespace mjcourse
