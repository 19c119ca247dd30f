#include "evaluate/scenes/model_lab.h"

#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "evaluate/scenes/lab.h"
#include "lesson/lesson_of_lab.h"

namespace mjcourse {
namespace {

using nlohmann::json;

constexpr std::size_t kMostControls = 10, kMostReadouts = 8;

std::string item(const std::string& array, int index) {
  return "data." + array + "[" + std::to_string(index) + "]";
}

json controls_of(const ModelPage& page, const Model& model) {
  json controls = json::array();
  for (const std::string& name : model.names(mjOBJ_KEY)) {
    if (controls.size() == kMostControls) break;
    controls.push_back({{"type", "keyframe"}, {"label", "Keyframe " + name}, {"key", name}});
  }
  for (int a = 0; a < model->nu && controls.size() < kMostControls; ++a) {
    const mjtNum* range = model->actuator_ctrlrange + std::ptrdiff_t{2} * a;
    const bool limited = model->actuator_ctrllimited[a] != 0;
    const double min = limited ? range[0] : -1, max = limited ? range[1] : 1;
    json slider{{"type", "slider"},
                {"label", page.actuators[static_cast<std::size_t>(a)].name},
                {"bind", item("ctrl", a)},
                {"min", min},
                {"max", max}};
    if (min > 0 || max < 0) slider["value"] = min > 0 ? min : max;
    controls.push_back(std::move(slider));
  }
  return controls;
}

json readouts_of(const ModelPage& page, const Model& model) {
  json readouts = json::array();
  for (int j = 0; j < model->njnt && readouts.size() < kMostReadouts; ++j) {
    const int type = model->jnt_type[j];
    if (type != mjJNT_SLIDE && type != mjJNT_HINGE) continue;
    readouts.push_back({{"label", page.joints[static_cast<std::size_t>(j)].name},
                        {"expr", item("qpos", model->jnt_qposadr[j])},
                        {"unit", type == mjJNT_SLIDE ? "m" : "rad"}});
  }
  return readouts;
}

std::string fence_of(const ModelPage& page, const View& view, json controls, json readouts) {
  const Lab::Camera& camera = view.camera;
  const json lab{{"title", page.name + ", live"},
                 {"model", page.name},
                 {"alt", alt_of(page)},
                 {"height", view.height},
                 {"camera",
                  {{"azimuth", camera.azimuth},
                   {"elevation", camera.elevation},
                   {"distance", camera.distance},
                   {"target", camera.target}}},
                 {"toggles", {"contacts", "forces", "joints", "frames", "transparent"}},
                 {"controls", std::move(controls)},
                 {"readouts", std::move(readouts)},
                 {"editable", true}};
  return "```lab simlab\n" + lab.dump() + "\n```\n";
}

std::optional<ModelPage::LiveLab> rehearsed(const std::string& name, const std::string& fence,
                                            WorkerContext& worker_context) {
  std::shared_ptr<const Lesson> lesson = lesson_of_lab(name, fence);
  if (!lesson->sound || lesson->blocks.size() != 1) return std::nullopt;
  const Lab& lab = std::get<Lab>(lesson->blocks.front());
  Diagnostics mistakes;
  std::optional<LabResult> result = rehearse_lab(lab, *lesson, worker_context, mistakes);
  if (!result) return std::nullopt;
  return ModelPage::LiveLab{std::move(lesson), *std::move(result)};
}

}  // namespace

std::vector<std::string> model_lab_fences(const ModelPage& page, const Model& model,
                                          const View& view) {
  const json readouts = readouts_of(page, model);
  return {fence_of(page, view, controls_of(page, model), readouts),
          fence_of(page, view, json::array(), readouts)};
}

std::optional<ModelPage::LiveLab> evaluate_model_lab(const std::string& name,
                                                     const std::vector<std::string>& fences,
                                                     WorkerContext& worker_context) {
  for (const std::string& fence : fences) {
    if (auto lab = rehearsed(name, fence, worker_context)) return lab;
  }
  return std::nullopt;
}

}  // namespace mjcourse
