#include "lesson/read_plot.h"

#include <string>
#include <utility>

namespace mjcourse {
namespace {

constexpr std::size_t kMostTraces = 4;  // as many as there are colours for data

Lab::Readout read_readout(const JsonValue& value, Reading& reading) {
  JsonObject object(value, "readout", reading);
  Lab::Readout readout;
  readout.label = object.required_string("label");
  readout.expression = object.required_string("expr");
  readout.digits = object.digits(readout.digits);
  readout.unit = object.string("unit").text;
  object.finish();
  return readout;
}

Lab::Readout read_trace(const JsonValue& value, Reading& reading) {
  JsonObject object(value, "trace", reading);
  Lab::Readout trace;
  trace.label = object.required_string("label");
  trace.expression = object.required_string("expr");
  object.finish();
  return trace;
}

Lab::Plot read_plot(const JsonValue& value, Reading& reading) {
  JsonObject object(value, "plot", reading);
  Lab::Plot plot;
  plot.ylabel = object.string("ylabel").text;
  plot.window =
      object.number("window", plot.window, {0.1, 1000, "is a number of seconds: from 0.1 to 1000"});
  plot.ymin = object.optional_number("ymin");
  plot.ymax = object.optional_number("ymax");
  if (plot.ymin && plot.ymax && !(*plot.ymin < *plot.ymax)) {
    reading.error("E-json-range", object.find("ymax")->span,
                  "\"ymax\" is the upper end of the plot: more than \"ymin\"");
  }
  for (const JsonValue& value_of_trace :
       object.filled_list("traces", "add a trace: {\"label\": …, \"expr\": …}")) {
    Lab::Readout trace = read_trace(value_of_trace, reading);
    if (!trace.expression.text.empty()) plot.traces.push_back(std::move(trace));
  }
  if (plot.traces.size() > kMostTraces) {
    reading.error("E-lab-plot", plot.traces[kMostTraces].label.span(),
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

std::vector<Lab::Plot> read_plots(JsonObject& lab, Reading& reading) {
  std::vector<Lab::Plot> plots;
  for (const JsonValue& value : lab.list("plots")) plots.push_back(read_plot(value, reading));
  return plots;
}

}  // namespace mjcourse
