#include "page/blocks/lab_module.h"

#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "base/content_hash.h"
#include "base/files.h"
#include "findings/lab_scripts.h"
#include "page/html/lab_record.h"
#include "page/html/site_paths.h"
#include "script/page_function.h"

namespace mjcourse {
namespace {

using nlohmann::json;

// A lab as JSON, in which every script of the author's is an index into a list of functions.
class LabDescription {
 public:
  LabDescription(const Lab& lab, const LabResult& result, const LessonContext& context)
      : lab_(lab), result_(result), context_(context) {}

  json describe(const std::map<std::string, std::string>& assets);
  const std::vector<std::string>& functions() const { return functions_; }

 private:
  std::size_t add(std::string function) {
    functions_.push_back(std::move(function));
    return functions_.size() - 1;
  }
  const std::string& guarded(const LocatedText& text, ScriptKind kind) const {
    return mjcourse::guarded(result_.scripts, text.text, kind);
  }
  std::size_t script(const LocatedText& text) {
    return add(page_script(guarded(text, ScriptKind::script), result_.script_names));
  }
  std::size_t value(const LocatedText& text) {
    return add(page_expression(guarded(text, ScriptKind::value), result_.script_names));
  }

  json control(const Lab::Button& button, std::size_t index);
  json control(const Lab::Slider& slider, std::size_t index);
  json control(const Lab::Toggle& toggle, std::size_t index);
  json control(const Lab::Select& select, std::size_t index);
  json control(const Lab::Keyframe& keyframe, std::size_t index);
  json controls();
  json readouts();
  json plots();
  json predict();
  json goal();
  json ghost();
  json editable();

  const Lab& lab_;
  const LabResult& result_;
  const LessonContext& context_;
  std::vector<std::string> functions_;
};

json number_or_null(const std::optional<double>& number) {
  return number ? json(*number) : json(nullptr);
}

json LabDescription::control(const Lab::Button& button, std::size_t) {
  return {{"type", "button"}, {"label", button.label.text}, {"run", script(button.run)}};
}

json LabDescription::control(const Lab::Slider& slider, std::size_t) {
  return {{"type", "slider"},
          {"label", slider.label.text},
          {"bind", slider.bind.text},
          {"read", value(slider.bind)},
          {"write", add(page_assignment(guarded(slider.bind, ScriptKind::assignment),
                                        result_.script_names))},
          {"min", slider.min},
          {"max", slider.max},
          {"step", slider.step_size()},
          {"value", number_or_null(slider.value)},
          {"digits", slider.digits},
          {"unit", slider.unit}};
}

json LabDescription::control(const Lab::Toggle& toggle, std::size_t) {
  return {{"type", "toggle"},
          {"label", toggle.label.text},
          {"on", script(toggle.on)},
          {"off", script(toggle.off)},
          {"value", toggle.value}};
}

json LabDescription::control(const Lab::Select& select, std::size_t) {
  json options = json::array();
  for (const Lab::Select::Option& option : select.options) {
    options.push_back({{"label", option.label.text}, {"run", script(option.run)}});
  }
  return {{"type", "select"},
          {"label", select.label.text},
          {"options", std::move(options)},
          {"value", select.has_value ? json(select.value) : json(nullptr)}};
}

json LabDescription::control(const Lab::Keyframe& keyframe, std::size_t index) {
  return {{"type", "keyframe"}, {"label", keyframe.label.text}, {"key", result_.keyframes[index]}};
}

json LabDescription::controls() {
  json controls = json::array();
  for (std::size_t i = 0; i < lab_.controls.size(); ++i) {
    std::visit([&](const auto& found) { controls.push_back(control(found, i)); }, lab_.controls[i]);
  }
  return controls;
}

json LabDescription::readouts() {
  json readouts = json::array();
  for (const Lab::Readout& readout : lab_.readouts) {
    readouts.push_back({{"label", readout.label.text},
                        {"value", value(readout.expression)},
                        {"digits", readout.digits},
                        {"unit", readout.unit}});
  }
  return readouts;
}

json LabDescription::plots() {
  json plots = json::array();
  for (const Lab::Plot& plot : lab_.plots) {
    json traces = json::array();
    for (const Lab::Readout& trace : plot.traces) {
      traces.push_back({{"label", trace.label.text}, {"value", value(trace.expression)}});
    }
    plots.push_back({{"ylabel", plot.ylabel},
                     {"window", plot.window},
                     {"ymin", number_or_null(plot.ymin)},
                     {"ymax", number_or_null(plot.ymax)},
                     {"traces", std::move(traces)}});
  }
  return plots;
}

json LabDescription::predict() {
  if (!lab_.predict) return nullptr;
  const Lab::Predict& predict = *lab_.predict;
  return {{"question", context_.scripted_html(predict.question)},
          {"run", predict.run.text.empty() ? json(nullptr) : json(script(predict.run))},
          {"seconds", predict.seconds},
          {"value", value(predict.value)},
          {"digits", predict.digits},
          {"unit", predict.unit},
          {"tolerance", predict.tolerance},
          {"explanation", context_.scripted_html(predict.explanation)}};
}

json LabDescription::goal() {
  if (!lab_.goal) return nullptr;
  return {{"text", context_.scripted_html(lab_.goal->text)}, {"done", value(lab_.goal->done)}};
}

json LabDescription::ghost() {
  if (!lab_.ghost) return nullptr;
  return {{"label", lab_.ghost->label}, {"run", script(lab_.ghost->run)}};
}

json LabDescription::editable() {
  if (!lab_.editable) return nullptr;
  json tasks = json::array();
  for (const Lab::Task& task : lab_.tasks) {
    tasks.push_back({{"question", context_.scripted_html(task.question)},
                     {"value", value(task.value)},
                     {"tolerance", task.tolerance},
                     {"unit", task.unit}});
  }
  return {{"tasks", std::move(tasks)}};
}

// `assets` has the addresses of the model's.
json LabDescription::describe(const std::map<std::string, std::string>& assets) {
  json toggles = json::array();
  for (const LocatedText& toggle : lab_.toggles) toggles.push_back(toggle.text);
  const Lab::Camera& camera = result_.camera;
  const LabModel& model = result_.model;
  return {{"title", lab_.title},
          {"model", {{"name", model.main}, {"texts", model.texts}, {"assets", assets}}},
          {"height", lab_.height},
          {"camera",
           {{"azimuth", camera.azimuth},
            {"elevation", camera.elevation},
            {"distance", camera.distance},
            {"target", camera.target}}},
          {"toggles", std::move(toggles)},
          {"overlays", result_.overlays},
          {"controls", controls()},
          {"readouts", readouts()},
          {"plots", plots()},
          {"speed", lab_.speed},
          {"predict", predict()},
          {"goal", goal()},
          {"ghost", ghost()},
          {"editable", editable()}};
}

// The site's path of an asset: its own name and a hash of its content, so that two models' files of
// one name do not meet.
std::string asset_path(const std::string& name, const std::filesystem::path& file) {
  const auto bytes = read_file(file);
  if (!bytes) throw LostFile(bytes.error());
  const std::filesystem::path plain(name);
  return "models/" + plain.stem().string() + "-" + content_hash(*bytes) +
         plain.extension().string();
}

}  // namespace

LabFiles write_lab_module(const Lab& lab, const LabResult& result, const std::string& name,
                          const LessonContext& context) {
  LabFiles files;
  const std::string base = "labs/" + name;
  std::map<std::string, std::string> assets;
  for (const auto& [asset, file] : result.model.assets) {
    const std::string path = asset_path(asset, file);
    files.copied[path] = file;
    assets[asset] = way_to_root(base) + site_address(path);
  }
  LabDescription description(lab, result, context);
  std::string text =
      "export const lab = " + description.describe(assets).dump() + ";\nexport const scripts = [\n";
  for (const std::string& function : description.functions()) text += function + ",\n";
  text += "];\n";
  files.written[base + ".rehearsal.json"] = lab_record(lab, result);
  files.module = base + "-" + content_hash(text) + ".js";
  files.written[files.module] = std::move(text);
  return files;
}

}  // namespace mjcourse
