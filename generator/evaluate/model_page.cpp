#include "evaluate/model_page.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "base/utf8.h"
#include "physics/model_files.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 712, kHeight = 400;  // CSS pixels of the picture

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

// Whoever downloads the model needs these; what lies outside of the course is not handed on.
std::vector<ModelPage::File> files_of(const fs::path& root, const std::string& main) {
  std::map<std::string, std::string> others;
  if (const auto sources = find_model_sources((root / main).string())) {
    const auto add = [&](const std::string& path, bool is_text) {
      const std::string below =
          fs::path(path).lexically_normal().lexically_relative(root.lexically_normal()).string();
      if (below.starts_with("..") || below == main) return;
      others[below] = is_text ? DiskFiles(root).read(below).value_or("") : "";
    };
    for (const auto& [name, path] : sources->texts) add(path, true);
    for (const auto& [name, path] : sources->assets) add(path, false);
  }
  std::vector<ModelPage::File> files{{main, DiskFiles(root).read(main).value()}};
  for (const auto& [path, text] : others) files.push_back({path, text});
  return files;
}

class PageMaker {
 public:
  PageMaker(Workshop& workshop, const Lesson& from, const LocatedText& name,
            Diagnostics& diagnostics)
      : workshop_(workshop), from_(from), name_(name), diagnostics_(diagnostics) {}

  std::optional<ModelPage> make() {
    const auto simulation = workshop_.simulate_named(name_, *from_.source, diagnostics_);
    if (!simulation) return std::nullopt;
    const Model& model = simulation->model();
    ModelPage page;
    page.name = name_.text;
    page.sizes = {{"nq", model->nq},           {"nv", model->nv},     {"nu", model->nu},
                  {"nbody", model->nbody},     {"njnt", model->njnt}, {"ngeom", model->ngeom},
                  {"nsensor", model->nsensor}, {"nkey", model->nkey}};
    page.timestep = number(model->opt.timestep);
    page.joints = joints_of(model);
    page.actuators = actuators_of(model);
    page.sensors = sensors_of(model);
    page.keyframes = keyframes_of(model);
    page.files = files_of(workshop_.root(), "models/" + name_.text + ".xml");
    for (const ModelPage::File& file : page.files) {
      if (!find_invalid_utf8(file.text)) continue;
      return refuse("E-model-utf8", file.path + " is not UTF-8, as its page needs it",
                    "save it as UTF-8");
    }
    return draw(*simulation, page) ? std::optional(std::move(page)) : std::nullopt;
  }

 private:
  bool draw(const Simulation& simulation, ModelPage& page) {
    const tl::expected<Renderer*, std::string> renderer = workshop_.renderer();
    if (!renderer) {
      refuse("E-picture", "no picture can be drawn: " + renderer.error(), "");
      return false;
    }
    const mjStatistic& seen = simulation.model()->stat;
    const Camera camera{
        90, -30, 1.5 * seen.extent, {seen.center[0], seen.center[1], seen.center[2]}};
    const auto picture = (*renderer)->render(simulation, camera, {}, {2 * kWidth, 2 * kHeight});
    if (!picture) {
      refuse("E-picture", "the model's picture cannot be drawn: " + picture.error(), "");
      return false;
    }
    page.poster = {encode_webp(*picture), encode_png(*picture), kWidth, kHeight};
    return true;
  }

  std::nullopt_t refuse(const std::string& id, const std::string& message,
                        const std::string& cure) {
    diagnostics_.push_back(error_at(place_of(*from_.source, name_.span()), id, message, cure));
    return std::nullopt;
  }

  Workshop& workshop_;
  const Lesson& from_;
  const LocatedText& name_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::vector<ModelPage> evaluate_model_pages(Workshop& workshop, Diagnostics& diagnostics) {
  constexpr std::string_view scheme = "model:";
  const std::vector<std::string>& known = workshop.course().models;
  std::map<std::string, std::optional<ModelPage>> pages;
  for (const Lesson* from : workshop.course().pages()) {
    for (const Link& link : from->links) {
      if (from->front.draft || !link.target.text.starts_with(scheme)) continue;
      const LocatedText name = link.target.part(scheme.size(), link.target.text.size());
      // An unknown one was reported when the course was read.
      if (std::find(known.begin(), known.end(), name.text) == known.end()) continue;
      if (pages.contains(name.text)) continue;
      pages[name.text] = PageMaker(workshop, *from, name, diagnostics).make();
    }
  }
  std::vector<ModelPage> made;
  for (auto& [name, page] : pages) {
    if (page) made.push_back(*std::move(page));
  }
  return made;
}

}  // namespace mjcourse
