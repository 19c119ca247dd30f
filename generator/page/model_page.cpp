#include "page/model_page.h"

#include "course/uses.h"
#include "findings/model_page.h"
#include "page/html/site_paths.h"
#include "page/html/uses_data.h"

namespace mjcourse {
namespace {

using nlohmann::json;

// "qpos[7:11]", as the lessons' programs print it.
std::string slice(const std::string& array, const ModelPage::Range& range) {
  return array + "[" + std::to_string(range.first) + ":" +
         std::to_string(range.first + range.count) + "]";
}

// A table of no rows is null, and left out.
json table(const std::string& title, const std::vector<std::string>& head, json rows) {
  if (rows.empty()) return nullptr;
  return {{"title", title}, {"head", head}, {"rows", std::move(rows)}};
}

json cell(const std::string& text, bool is_code = false) {
  return {{"text", text}, {"code", is_code && !text.empty()}};
}

json tables_of(const ModelPage& model) {
  json joints = json::array(), actuators = json::array(), sensors = json::array(),
       keyframes = json::array();
  for (const ModelPage::Joint& joint : model.joints) {
    joints.push_back({cell(joint.name, true), cell(joint.type), cell(joint.body, true),
                      cell(slice("qpos", joint.qpos), true), cell(slice("qvel", joint.dof), true),
                      cell(joint.limits)});
  }
  for (const ModelPage::Actuator& actuator : model.actuators) {
    actuators.push_back({cell(actuator.name, true), cell(actuator.on), cell(actuator.limits)});
  }
  for (const ModelPage::Sensor& sensor : model.sensors) {
    sensors.push_back(
        {cell(sensor.name, true), cell(sensor.of), cell(slice("sensordata", sensor.data), true)});
  }
  for (const ModelPage::Keyframe& keyframe : model.keyframes) {
    keyframes.push_back({cell(keyframe.name, true), cell(keyframe.time)});
  }
  json tables = json::array();
  for (json& one : std::vector<json>{
           table("Joints", {"Name", "Type", "Body", "Positions", "Velocities", "Range"}, joints),
           table("Actuators", {"Name", "Drives", "Control range"}, actuators),
           table("Sensors", {"Name", "Of", "Readings"}, sensors),
           table("Keyframes", {"Name", "Time (s)"}, keyframes)}) {
    if (!one.is_null()) tables.push_back(std::move(one));
  }
  return tables;
}

// As lab.hbs wants it; null for none.
json lab_data(const ModelPage& model, const Course& course, const PageContext& context,
              std::vector<LabFiles>& files) {
  if (!model.lab) return nullptr;
  LessonResults results;
  results.of_block[0] = model.lab->result;
  PageWriter writer(course, *model.lab->lesson, results, context);
  json data = writer.lab(0);
  data["poster"] = poster_data(model, way_to_root(context.page), Loaded::at_once);
  files = writer.lab_files();
  return data;
}

}  // namespace

std::string model_poster_path(const ModelPage& model) {
  return "models/" + model.name + "-" + model.poster.webp.hash().substr(0, 10);
}

json poster_data(const ModelPage& model, const std::string& root, Loaded loaded) {
  return still_data(root + model_poster_path(model), model.poster.width, model.poster.height,
                    alt_of(model), loaded);
}

json sizes_data(const ModelPage& model) {
  json sizes = json::array();
  for (const auto& [name, count] : model.sizes) sizes.push_back({{"name", name}, {"value", count}});
  return sizes;
}

ModelPageHtml model_page(const ModelPage& model, const Course& course, const Evaluation& evaluation,
                         const PageContext& context) {
  ModelPageHtml page;
  const std::string root = way_to_root(context.page);
  json files = json::array();
  for (const ModelPage::File& file : model.files) {
    files.push_back({{"id", nullptr},
                     {"file", file.path},
                     {"download", root + site_address(file.path)},
                     {"zip", nullptr},
                     {"exercise", nullptr},
                     {"run", nullptr},
                     {"why_not", nullptr},
                     {"code", context.highlighter.highlight(file.text, "xml")},
                     {"is_text", !file.text.empty()},
                     {"unchecked", false},
                     {"output", nullptr}});
  }
  page.body =
      render_template(context.templates, "model",
                      {{"name", model.name},
                       {"root", root},
                       {"poster", poster_data(model, root, Loaded::at_once)},
                       {"lab", lab_data(model, course, context, page.lab_files)},
                       {"sizes", sizes_data(model)},
                       {"timestep", model.timestep},
                       {"tables", tables_of(model)},
                       {"files", std::move(files)},
                       {"uses", uses_data(uses_of_model(course, model.name), evaluation, root)}});
  return page;
}

}  // namespace mjcourse
