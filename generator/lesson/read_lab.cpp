#include "lesson/read_lab.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/nearest.h"
#include "lesson/json_object.h"

namespace mjcourse {
namespace {

// Nothing when there is nothing to read.
std::optional<Lab::Readout> read_readout(const JsonValue& value, const std::string& what,
                                         Reading& reading) {
  JsonObject object(value, what, reading);
  Lab::Readout readout;
  readout.label = object.required_string("label");
  readout.expression = object.required_string("expr");
  if (what == "readout") {
    readout.unit = object.string("unit").text;
    const double digits = object.number("digits", readout.digits);
    if (digits < 0 || digits > 15 || digits != std::floor(digits)) {
      reading.error("E-json-range", object.find("digits")->span,
                    "\"digits\" counts the digits after the point: a whole number from 0 to 15");
    } else {
      readout.digits = static_cast<int>(digits);
    }
  }
  object.finish();
  return readout.expression.text.empty() ? std::nullopt : std::optional(readout);
}

Lab::Camera read_camera(const JsonValue& value, Reading& reading) {
  JsonObject object(value, "camera", reading);
  Lab::Camera camera;
  camera.azimuth = object.number("azimuth", camera.azimuth);
  camera.elevation = object.number("elevation", camera.elevation);
  camera.distance = object.number("distance", camera.distance);
  const std::vector<JsonValue>& target = object.list("target");
  for (std::size_t i = 0; i < target.size() && i < 3; ++i) camera.target[i] = target[i].number;
  const bool numbers = std::all_of(target.begin(), target.end(), [](const JsonValue& item) {
    return item.kind == JsonValue::Kind::number;
  });
  if (object.has("target") && (target.size() != 3 || !numbers)) {
    reading.error("E-json-range", object.find("target")->span,
                  "\"target\" is a point: three numbers, in metres");
  }
  object.finish();
  return camera;
}

std::optional<Lab::Button> read_control(const JsonValue& value, Reading& reading) {
  JsonObject object(value, "control", reading);
  const LocatedText type = object.required_string("type");
  for (const char* later : {"slider", "toggle", "select", "keyframe"}) {
    if (type.text != later) continue;
    reading.error("E-not-yet", type.span(),
                  "a \"" + type.text +
                      "\" belongs to the lesson language, but this version of "
                      "mjcourse cannot do it yet",
                  "use a \"button\" for now");
    return std::nullopt;
  }
  if (type.text != "button") {
    if (!type.text.empty()) {
      reading.error("E-lab-control", type.span(), "there is no control \"" + type.text + "\"",
                    suggest(type.text, {"button"}));
    }
    return std::nullopt;
  }
  Lab::Button button{object.required_string("label"), object.script("run")};
  if (button.run.text.empty() && !object.has("run")) {
    reading.error("E-json-missing", {value.span.begin, value.span.begin + 1},
                  "this button does nothing: it has no \"run\"", "add \"run\": a script");
  }
  object.finish();
  return button;
}

Lab::Plot read_plot(const JsonValue& value, Reading& reading) {
  JsonObject object(value, "plot", reading);
  Lab::Plot plot;
  plot.ylabel = object.string("ylabel").text;
  plot.window = object.number("window", plot.window);
  plot.ymin = object.optional_number("ymin");
  plot.ymax = object.optional_number("ymax");
  for (const JsonValue& trace : object.required_list("traces")) {
    if (auto read = read_readout(trace, "trace", reading)) plot.traces.push_back(*read);
  }
  object.finish();
  return plot;
}

std::vector<Lab::Overlay> read_overlays(const JsonValue* value, Reading& reading) {
  std::vector<Lab::Overlay> overlays;
  if (value == nullptr) return overlays;
  if (value->kind != JsonValue::Kind::object) {
    report_kind("overlays", *value, "an object: {\"frames\": true}", reading);
  }
  for (const JsonMember& member : value->members) {
    if (member.value.kind != JsonValue::Kind::boolean) {
      report_kind(member.key.text, member.value, "true or false", reading);
    }
    overlays.push_back({member.key, member.value.boolean});
  }
  return overlays;
}

}  // namespace

std::optional<Lab> read_lab(Fence& fence, LessonReader& reader) {
  Reading& reading = reader.reading();
  fence.finish("lab simlab", reading);
  const std::optional<JsonValue> json = parse_json(fence.body(), reading);
  if (!json) return std::nullopt;
  JsonObject object(*json, "lab", reading);
  Lab lab;
  lab.span = fence.span();
  lab.title = object.required_string("title").text;
  lab.model = object.required_string("model");
  lab.dock = object.boolean("dock", lab.dock);
  const double height = object.number("height", lab.height);
  if (height >= 1 && height <= 10000) {
    lab.height = static_cast<int>(height);
  } else {
    reading.error("E-json-range", object.find("height")->span,
                  "\"height\" is a number of pixels: from 1 to 10000");
  }
  if (const JsonValue* camera = object.find("camera")) lab.camera = read_camera(*camera, reading);
  for (const JsonValue& toggle : object.list("toggles")) {
    if (toggle.kind == JsonValue::Kind::string) {
      lab.toggles.push_back(toggle.string);
    } else {
      report_kind("toggles", toggle, "a string", reading);
    }
  }
  lab.overlays = read_overlays(object.find("overlays"), reading);
  for (const JsonValue& control : object.list("controls")) {
    if (auto button = read_control(control, reading)) lab.controls.push_back(std::move(*button));
  }
  for (const JsonValue& readout : object.list("readouts")) {
    if (auto read = read_readout(readout, "readout", reading)) lab.readouts.push_back(*read);
  }
  for (const JsonValue& plot : object.list("plots")) lab.plots.push_back(read_plot(plot, reading));
  lab.note = reader.fragment(object.string("note"));
  for (const char* later : {"predict", "goal", "speed", "ghost", "editable"}) object.not_yet(later);
  object.finish();
  if (lab.model.text.empty()) return std::nullopt;
  return lab;
}

}  // namespace mjcourse
