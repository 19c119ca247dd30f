#include "lesson/read_control.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "base/nearest.h"

namespace mjcourse {
namespace {

// Whether `way` is a whole number of `step`s, but for what binary doubles lose.
bool is_reached(double way, double step) {
  const double steps = way / step;
  return std::abs(steps - std::round(steps)) < 1e-6;
}

// Whether a slider's numbers go together; if not, that is reported at the key which does not.
bool check_numbers(const Lab::Slider& slider, JsonObject& object, Reading& reading) {
  const auto refuse = [&](const std::string& key, const std::string& message,
                          const std::string& cure) {
    reading.error("E-lab-slider", object.find(key)->span, message, cure);
    return false;
  };
  const auto is_number = [&](const std::string& key) {
    const JsonValue* value = object.find(key);
    return value != nullptr && value->kind == JsonValue::Kind::number;
  };
  if (!is_number("min") || !is_number("max")) return false;
  const double way = slider.max - slider.min;
  if (!(way > 0)) {
    return refuse("max", "a slider goes up from \"min\" to \"max\"", "make \"max\" the larger one");
  }
  if (slider.step && (*slider.step > way || !is_reached(way, *slider.step))) {
    return refuse("step", "the steps do not reach from \"min\" to \"max\"",
                  "make \"max\" - \"min\" a whole number of steps");
  }
  if (slider.value && (*slider.value < slider.min || *slider.value > slider.max)) {
    return refuse("value", "the slider starts outside of its \"min\" and \"max\"",
                  "choose a value between them");
  }
  if (slider.step && slider.value && !is_reached(*slider.value - slider.min, *slider.step)) {
    return refuse("value", "the slider starts between two of its steps",
                  "make \"value\" - \"min\" a whole number of steps");
  }
  return true;
}

using Read = std::optional<Lab::Control>;

// A script that may be empty, but not be forgotten: "this button does nothing".
LocatedText read_run(JsonObject& object, const std::string& what, Reading& reading) {
  if (object.is_object() && !object.has("run")) {
    reading.error("E-json-missing", {object.span().begin, object.span().begin + 1},
                  "this " + what + " does nothing: it has no \"run\"", "add \"run\": a script");
  }
  return object.script("run");
}

Read read_button(JsonObject& object, LocatedText label, Reading& reading) {
  return Lab::Button{std::move(label), read_run(object, "button", reading)};
}

Read read_slider(JsonObject& object, LocatedText label, Reading& reading) {
  Lab::Slider slider;
  slider.label = std::move(label);
  slider.bind = object.required_string("bind");
  slider.min = object.required_number("min");
  slider.max = object.required_number("max");
  const double step =
      object.number("step", 0,
                    {std::numeric_limits<double>::min(), std::numeric_limits<double>::max(),
                     "is how far the slider goes at a time: more than 0"});
  if (step > 0) slider.step = step;
  slider.value = object.optional_number("value");
  slider.digits = object.digits(slider.digits);
  slider.unit = object.string("unit").text;
  const bool good = check_numbers(slider, object, reading) && !slider.bind.text.empty();
  return good ? Read(std::move(slider)) : std::nullopt;
}

Read read_toggle(JsonObject& object, LocatedText label) {
  Lab::Toggle toggle;
  toggle.label = std::move(label);
  toggle.on = object.required_script("on");
  toggle.off = object.required_script("off");
  toggle.value = object.boolean("value", false);
  return toggle;
}

Read read_select(JsonObject& object, LocatedText label, Reading& reading) {
  Lab::Select select;
  select.label = std::move(label);
  for (const JsonValue& option :
       object.filled_list("options", "add options: {\"label\": …, \"run\": …}")) {
    JsonObject choice(option, "option", reading);
    LocatedText option_label = choice.required_string("label");
    select.options.push_back({std::move(option_label), read_run(choice, "option", reading)});
    choice.finish();
  }
  if (select.options.empty()) {
    object.find("value");
    return std::nullopt;
  }
  const double last = static_cast<double>(select.options.size()) - 1;
  const NumberRule index{0, last, "is the index of an option, counted from 0", true};
  select.has_value = object.has("value");
  select.value = static_cast<std::size_t>(object.number("value", 0, index));
  return select;
}

Read read_keyframe(JsonObject& object, LocatedText label) {
  Lab::Keyframe keyframe{std::move(label), object.required_string("key")};
  return keyframe.key.text.empty() ? std::nullopt : Read(std::move(keyframe));
}

}  // namespace

std::optional<Lab::Control> read_control(const JsonValue& value, Reading& reading) {
  const LocatedText type = JsonObject(value, "control", reading).required_string("type");
  const std::vector<std::string> known{"button", "slider", "toggle", "select", "keyframe"};
  if (std::find(known.begin(), known.end(), type.text) == known.end()) {
    if (!type.text.empty()) {
      reading.error("E-lab-control", type.span(), "there is no control \"" + type.text + "\"",
                    suggest(type.text, known));
    }
    return std::nullopt;
  }
  JsonObject object(value, type.text, reading);
  object.find("type");
  LocatedText label = object.required_string("label");
  Read control;
  if (type.text == "button") {
    control = read_button(object, std::move(label), reading);
  } else if (type.text == "slider") {
    control = read_slider(object, std::move(label), reading);
  } else if (type.text == "toggle") {
    control = read_toggle(object, std::move(label));
  } else if (type.text == "select") {
    control = read_select(object, std::move(label), reading);
  } else {
    control = read_keyframe(object, std::move(label));
  }
  object.finish();
  return control;
}

}  // namespace mjcourse
