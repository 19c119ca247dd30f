#include "lsp/model_names.h"

#include <algorithm>
#include <map>
#include <utility>

#include "physics/data.h"
#include "physics/field_table.h"

namespace mjcourse {
namespace {

// What each lookup of scripts finds (site/press/script/lookups.ts).
const std::map<std::string, mjtObj>& lookups() {
  static const std::map<std::string, mjtObj> all{
      {"qpos", mjOBJ_JOINT},    {"qvel", mjOBJ_JOINT},   {"joint", mjOBJ_JOINT},
      {"body", mjOBJ_BODY},     {"geom", mjOBJ_GEOM},    {"site", mjOBJ_SITE},
      {"sensor", mjOBJ_SENSOR}, {"ctrl", mjOBJ_ACTUATOR}};
  return all;
}

// Every model has the same.
std::vector<std::string> field_names() {
  auto model = load_model_text("<mujoco/>");
  if (!model) return {};
  Data data(*model);
  std::vector<mjcField> of_model(
      static_cast<std::size_t>(mjc_model_fields(model->get(), nullptr, 0)));
  mjc_model_fields(model->get(), of_model.data(), static_cast<int>(of_model.size()));
  std::vector<mjcField> of_data(
      static_cast<std::size_t>(mjc_data_fields(model->get(), data.get(), nullptr, 0)));
  mjc_data_fields(model->get(), data.get(), of_data.data(), static_cast<int>(of_data.size()));
  std::vector<std::string> names;
  const auto add = [&](const std::string& root, const std::vector<mjcField>& fields) {
    for (const mjcField& field : fields) {
      const std::string owner = field.owner;
      names.push_back(root + (owner.empty() ? "." : "." + owner + ".") + field.name);
    }
  };
  add("model", of_model);
  add("data", of_data);
  return names;
}

}  // namespace

ModelNames::ModelNames(std::filesystem::path root)
    : root_(std::move(root)), fields_(field_names()) {}

std::vector<std::string> ModelNames::fields(const std::string& path) const {
  std::vector<std::string> names;
  for (const std::string& field : fields_) {
    if (!field.starts_with(path + ".")) continue;
    const std::string rest = field.substr(path.size() + 1);
    names.push_back(rest.substr(0, rest.find('.')));
  }
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

std::vector<std::string> ModelNames::objects(const std::string& model,
                                             const std::string& function) {
  const auto lookup = lookups().find(function);
  if (model.empty() || lookup == lookups().end()) return {};
  const auto loaded = model.starts_with('<') ? models_.text(model)
                                             : models_.file(root_, "models/" + model + ".xml");
  return loaded ? loaded->names(lookup->second) : std::vector<std::string>{};
}

}  // namespace mjcourse
