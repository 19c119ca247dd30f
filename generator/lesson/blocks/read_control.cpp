#include "lesson/blocks/read_control.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/nearest.h"
#include "lesson/json/lab_vocabulary.h"

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
LocatedText read_run(JsonObject& object, const std::string& what) {
  const bool there = object.require("run", "this " + what + " does nothing: it has no \"run\"",
                                    "add \"run\": a script") != nullptr;
  return there ? object.script("run") : LocatedText{};
}

Read read_button(JsonObject& object, LocatedText label) {
  return Lab::Button{std::move(label), read_run(object, "button")};
}

Read read_slider(JsonObject& object, LocatedText label, Reading& reading) {
  Lab::Slider slider;
  slider.label = std::move(label);
  slider.bind = object.string("bind");
  slider.min = object.number("min", 0);
  slider.max = object.number("max", 0);
  const double step = object.number("step", 0);
  if (step > 0) slider.step = step;
  slider.value = object.optional_number("value");
  slider.digits = object.whole("digits", slider.digits);
  slider.unit = object.string("unit").text;
  const bool good = check_numbers(slider, object, reading) && !slider.bind.text.empty();
  return good ? Read(std::move(slider)) : std::nullopt;
}

Read read_toggle(JsonObject& object, LocatedText label) {
  Lab::Toggle toggle;
  toggle.label = std::move(label);
  toggle.on = object.script("on");
  toggle.off = object.script("off");
  toggle.value = object.boolean("value", false);
  return toggle;
}

Read read_select(JsonObject& object, LocatedText label, Reading& reading) {
  Lab::Select select;
  select.label = std::move(label);
  for (const JsonValue& option :
       object.list("options", "add options: {\"label\": …, \"run\": …}")) {
    JsonObject choice(option, words::kChoice, reading);
    LocatedText option_label = choice.string("label");
    select.options.push_back({std::move(option_label), read_run(choice, "option")});
    choice.finish();
  }
  if (select.options.empty()) {
    object.find("value");
    return std::nullopt;
  }
  const double last = static_cast<double>(select.options.size()) - 1;
  Limits index = words::kSelect.find("value")->limits;
  index.most = last;
  select.has_value = object.has("value");
  select.value = static_cast<std::size_t>(object.number("value", 0, index));
  return select;
}

Read read_keyframe(JsonObject& object, LocatedText label) {
  Lab::Keyframe keyframe{std::move(label), object.string("key")};
  return keyframe.key.text.empty() ? std::nullopt : Read(std::move(keyframe));
}

}  // namespace

std::optional<Lab::Control> read_control(const JsonValue& value, Reading& reading) {
  const LocatedText type = JsonObject(value, words::kControl, reading).string("type");
  const Vocabulary* vocabulary = words::kControl.variant(type.text);
  if (vocabulary == nullptr) {
    if (!type.text.empty()) {
      std::vector<std::string> known;
      for (const Variant& one : words::kControl.variants) known.emplace_back(one.word);
      reading.error("E-lab-control", type.span(), "there is no control \"" + type.text + "\"",
                    suggest(type.text, known));
    }
    return std::nullopt;
  }
  JsonObject object(value, *vocabulary, reading);
  object.find("type");
  LocatedText label = object.string("label");
  Read control;
  if (type.text == "button") {
    control = read_button(object, std::move(label));
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
