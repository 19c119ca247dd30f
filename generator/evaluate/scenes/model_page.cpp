#include "evaluate/scenes/model_page.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "evaluate/context/block_context.h"
#include "evaluate/scenes/model_lab.h"
#include "evaluate/scenes/step_count.h"
#include "evaluate/scenes/view.h"
#include "physics/model_files.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

constexpr int kPictureWidth = 712, kPictureHeight = 400;  // CSS pixels of the picture

// With a true minus sign.
std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", std::abs(x));
  return (x < 0 ? "−" : "") + std::string(text);
}

std::string interval(const mjtNum* range, const std::string& unit) {
  return number(range[0]) + " … " + number(range[1]) + (unit.empty() ? "" : " " + unit);
}

// The object's name, or its kind and number.
std::string name_of(const Model& model, mjtObj type, int id) {
  const std::string name = model.name(type, id);
  return name.empty() ? std::string(mju_type2Str(type)) + " " + std::to_string(id) : name;
}

std::vector<ModelPage::Joint> joints_of(const Model& model) {
  constexpr struct {
    const char* name;
    int qpos, dof;
    const char* unit;
  } types[] = {
      {"free", 7, 6, ""}, {"ball", 4, 3, "rad"}, {"slide", 1, 1, "m"}, {"hinge", 1, 1, "rad"}};
  std::vector<ModelPage::Joint> joints;
  for (int j = 0; j < model->njnt; ++j) {
    const auto& type = types[model->jnt_type[j]];
    joints.push_back({name_of(model, mjOBJ_JOINT, j),
                      type.name,
                      name_of(model, mjOBJ_BODY, model->jnt_bodyid[j]),
                      {model->jnt_qposadr[j], type.qpos},
                      {model->jnt_dofadr[j], type.dof},
                      model->jnt_limited[j] != 0
                          ? interval(model->jnt_range + std::ptrdiff_t{2} * j, type.unit)
                          : ""});
  }
  return joints;
}

std::vector<ModelPage::Actuator> actuators_of(const Model& model) {
  const auto driven = [&](int a) -> std::string {
    const int id = model->actuator_trnid[std::ptrdiff_t{2} * a];
    switch (model->actuator_trntype[a]) {
      case mjTRN_JOINT:
      case mjTRN_JOINTINPARENT:
        return "joint " + name_of(model, mjOBJ_JOINT, id);
      case mjTRN_TENDON:
        return "tendon " + name_of(model, mjOBJ_TENDON, id);
      case mjTRN_SITE:
      case mjTRN_SLIDERCRANK:
        return "site " + name_of(model, mjOBJ_SITE, id);
      default:
        return "";
    }
  };
  std::vector<ModelPage::Actuator> actuators;
  for (int a = 0; a < model->nu; ++a) {
    actuators.push_back({name_of(model, mjOBJ_ACTUATOR, a), driven(a),
                         model->actuator_ctrllimited[a] != 0
                             ? interval(model->actuator_ctrlrange + std::ptrdiff_t{2} * a, "")
                             : ""});
  }
  return actuators;
}

std::vector<ModelPage::Sensor> sensors_of(const Model& model) {
  std::vector<ModelPage::Sensor> sensors;
  for (int s = 0; s < model->nsensor; ++s) {
    const auto type = static_cast<mjtObj>(model->sensor_objtype[s]);
    const bool has_object = type != mjOBJ_UNKNOWN && model->sensor_objid[s] >= 0;
    sensors.push_back({name_of(model, mjOBJ_SENSOR, s),
                       has_object ? std::string(mju_type2Str(type)) + " " +
                                        name_of(model, type, model->sensor_objid[s])
                                  : "",
                       {model->sensor_adr[s], model->sensor_dim[s]}});
  }
  return sensors;
}

std::vector<ModelPage::Keyframe> keyframes_of(const Model& model) {
  std::vector<ModelPage::Keyframe> keyframes;
  for (int k = 0; k < model->nkey; ++k) {
    keyframes.push_back({name_of(model, mjOBJ_KEY, k), number(model->key_time[k])});
  }
  return keyframes;
}

// A download of the model needs these; what lies outside of the course is not handed on.
std::vector<ModelPage::File> files_of(const fs::path& root, const std::string& main) {
  std::map<std::string, std::string> others;
  if (const auto sources = find_model_sources(root, main)) {
    const auto add = [&](const std::string& path, bool is_text) {
      const std::string below =
          fs::path(path).lexically_normal().lexically_relative(root.lexically_normal()).string();
      if (below.starts_with("..") || below == main) return;
      others[below] = is_text ? DiskFiles(root).read(below).value_or("") : "";
    };
    for (const auto& [name, path] : sources->texts) add(path, true);
    for (const auto& [name, path] : sources->assets) add(path, false);
  }
  std::vector<ModelPage::File> files{{main, read_again(DiskFiles(root), main)}};
  for (const auto& [path, text] : others) files.push_back({path, text});
  return files;
}

// All of the model, also as it moves for two seconds, from less high above than a figure has it.
View portrait_of(Simulation& simulation) {
  WholeView seen(simulation.model(), {.elevation = -30});
  seen.add(simulation);
  const int frames = step_count(simulation.model(), 2) ? 50 : 0;
  for (int frame = 0; frame < frames && !simulation.stopped(); ++frame) {
    simulation.advance(2.0 / frames);
    if (!simulation.stopped()) seen.add(simulation);
  }
  simulation.reset();
  return {camera_of(std::nullopt, seen), {}, kPictureWidth, kPictureHeight};
}

}  // namespace

std::optional<ModelPage> evaluate_model_page(const LocatedText& name, const BlockContext& context) {
  WorkerContext& worker_context = context.worker_context();
  std::optional<Simulation> simulation =
      worker_context.simulate_named(name, *context.lesson().source, context.diagnostics());
  if (!simulation) return std::nullopt;
  const Model& model = simulation->model();
  ModelPage page;
  page.name = name.text;
  page.sizes = {{"nq", model->nq},           {"nv", model->nv},     {"nu", model->nu},
                {"nbody", model->nbody},     {"njnt", model->njnt}, {"ngeom", model->ngeom},
                {"nsensor", model->nsensor}, {"nkey", model->nkey}};
  page.timestep = number(model->opt.timestep);
  page.joints = joints_of(model);
  page.actuators = actuators_of(model);
  page.sensors = sensors_of(model);
  page.keyframes = keyframes_of(model);
  page.files = files_of(worker_context.root(), "models/" + name.text + ".xml");
  const View view = portrait_of(*simulation);
  const auto picture = draw(*simulation, view, "the model's picture", name.span(), context);
  if (!picture) return std::nullopt;
  page.poster = poster_of(*picture, view);
  const std::vector<std::string> fences = model_lab_fences(page, model, view);
  simulation.reset();  // a large model is not there twice
  page.lab = evaluate_model_lab(page.name, fences, worker_context);
  return page;
}

}  // namespace mjcourse
