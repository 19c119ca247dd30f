#include "lesson/blocks/read_lab.h"

#include <string>
#include <utility>

#include "lesson/blocks/block_scripts.h"
#include "lesson/blocks/read_assignment.h"
#include "lesson/blocks/read_control.h"
#include "lesson/blocks/read_lab_plots.h"
#include "lesson/blocks/read_view.h"
#include "lesson/json/json_object.h"
#include "lesson/json/lab_vocabulary.h"

namespace mjcourse {
namespace {

std::optional<Lab::Ghost> read_ghost(const JsonValue* value, Reading& reading) {
  if (value == nullptr) return std::nullopt;
  JsonObject object(*value, words::kGhost, reading);
  Lab::Ghost ghost{object.string("label").text, object.script("run")};
  object.finish();
  return ghost.run.text.empty() ? std::nullopt : std::optional(ghost);
}

// What a lab defines is run before each of its scripts, so a long text would soon be an enormous
// one.
constexpr std::size_t kMostDefined = 16 << 20;  // bytes, before all scripts together

bool has_bounded_definitions(const Lab& lab, Reading& reading) {
  const std::size_t scripts = scripts_of(lab).size();
  if (lab.define.text.size() * scripts <= kMostDefined) return true;
  reading.error("E-lab-define", lab.define.span(),
                "`define` stands before each script: " + std::to_string(lab.define.text.size()) +
                    " bytes, " + std::to_string(scripts) + " times, are more than 16 MiB",
                "define less, or split the lab");
  return false;
}

}  // namespace

std::optional<Lab> read_lab(Fence& fence, LessonReader& reader) {
  Reading& reading = reader.reading();
  fence.finish("lab simlab", {}, reading);
  const std::optional<JsonValue> json = parse_json(fence.body(), reading);
  if (!json) return std::nullopt;
  JsonObject object(*json, words::kLab, reading);
  Lab lab;
  lab.span = fence.span();
  lab.title = object.string("title").text;
  lab.model = object.string("model");
  lab.dock = object.boolean("dock", lab.dock);
  lab.height = static_cast<int>(object.number("height", lab.height));
  lab.camera = read_camera(object, reading);
  for (const JsonValue& toggle : object.list("toggles")) {
    if (toggle.kind == JsonValue::Kind::string) {
      lab.toggles.push_back(toggle.string);
    } else {
      report_kind("toggles", toggle, "a string", reading);
    }
  }
  lab.overlays = read_overlays(object, reading);
  lab.define = object.script("define");
  for (const JsonValue& control : object.list("controls")) {
    if (auto read = read_control(control, reading)) lab.controls.push_back(std::move(*read));
  }
  lab.readouts = read_readouts(object, reading);
  lab.plots = read_lab_plots(object, reading);
  lab.speed = object.number("speed", lab.speed);
  lab.predict = read_predict(object.find("predict"), reader);
  lab.editable = read_editable(object.find("editable"), reader, lab.tasks);
  lab.goal = read_goal(object.find("goal"), lab.editable, reader);
  lab.ghost = read_ghost(object.find("ghost"), reading);
  lab.alt = read_alt(object, reading);
  lab.pin = read_pin(object, reading);
  lab.note = reader.fragment(object.string("note"));
  object.finish();
  if (lab.model.text.empty() || !has_bounded_definitions(lab, reading)) return std::nullopt;
  return lab;
}

}  // namespace mjcourse
