#include "page/blocks/lab_data.h"

#include <algorithm>
#include <utility>

#include "page/blocks/lab_module.h"
#include "page/blocks/program_data.h"
#include "page/html/fixed_number.h"
#include "page/html/lesson_pictures.h"
#include "page/html/site_paths.h"
#include "page/html/still_data.h"

namespace mjcourse {
namespace {

using nlohmann::json;

constexpr int kTraceDigits = 4;

std::string label_of(const Lab::Control& control) {
  return std::visit([](const auto& of_kind) { return of_kind.label.text; }, control);
}

// Where a reader of a printed lab finds it: below the site's root, where that has no address.
std::string address_of(const Course& course, const Lesson& lesson, const std::string& id) {
  const std::string path = page_path(lesson);
  return (course.url.empty() ? path : web_address(course, path)) + "#" + id;
}

// What the lab asks, for those who cannot have it live.
json asked_data(const Lab& lab, const LessonContext& context) {
  json asked = json::array();
  const auto ask = [&](const std::string& label, bool task, const Document& text) {
    asked.push_back({{"label", label}, {"task", task}, {"html", context.html(text)}});
  };
  if (lab.predict) ask("A guess first", false, lab.predict->question);
  if (lab.goal) ask("Goal", false, lab.goal->text);
  for (const Lab::Task& task : lab.tasks) ask("To find", true, task.question);
  return asked;
}

// A lab that takes more than this of the 2 GiB that all labs of a page share is loaded only when
// its reader presses Play. None is to be in the way of another unasked.
constexpr std::uint64_t kMostUnasked = 64 << 20;

// Where the page's script finds what makes a lab live; null where the site has no engine for it.
json live_data(const Lab& lab, const LabResult& result, std::size_t index, LessonContext& context) {
  const std::string number =
      context.lesson.number + "-" + std::to_string(block_number(context.lesson, index));
  LabFiles files = write_lab_module(lab, result, number, context);
  json data = nullptr;
  if (context.page.manifest.contains("engine.wasm")) {
    data = {{"module", context.from_root(files.module)}};
    for (const auto& [name, asset] : {std::pair("code", "lab.js"),
                                      {"style", "lab.css"},
                                      {"engine", "engine.mjs"},
                                      {"wasm", "engine.wasm"}}) {
      data[name] = context.from_root(context.page.manifest.at(asset).get<std::string>());
    }
    data["compiler"] = lab_compiler(context);
    data["large"] = result.memory > kMostUnasked;
  }
  context.lab_files.push_back(std::move(files));
  return data;
}

}  // namespace

json lab_data(const Lab& lab, std::size_t index, LessonContext& context) {
  const auto* result = context.results.get<LabResult>(index);
  json data{
      {"id", block_name(context.lesson, index)},
      {"title", lab.title},
      {"dock", lab.dock},
      {"live", nullptr},
      {"address", address_of(context.course, context.lesson, block_name(context.lesson, index))},
      {"poster", nullptr},
      {"asked", asked_data(lab, context)},
      {"controls", json::array()},
      {"readouts", json::array()},
      {"plots", json::array()},
      {"toggles", json::array()},
      {"note", context.inline_html(lab.note)}};
  if (result != nullptr) data["live"] = live_data(lab, *result, index, context);
  if (result != nullptr && result->poster) {
    const Poster& poster = *result->poster;
    data["poster"] =
        still_data("../" + block_path(context.lesson, index), poster.width, poster.height, lab.alt);
  }
  for (const Lab::Control& control : lab.controls) {
    data["controls"].push_back(label_of(control));
  }
  for (std::size_t i = 0; result != nullptr && i < lab.readouts.size(); ++i) {
    const Lab::Readout& readout = lab.readouts[i];
    data["readouts"].push_back({{"label", readout.label.text},
                                {"value", fixed_number(result->readouts[i], readout.digits)},
                                {"unit", readout.unit}});
  }
  for (std::size_t p = 0; result != nullptr && p < lab.plots.size(); ++p) {
    json traces = json::array();
    for (std::size_t t = 0; t < lab.plots[p].traces.size(); ++t) {
      traces.push_back({{"label", lab.plots[p].traces[t].label.text},
                        {"value", fixed_number(result->traces[p][t], kTraceDigits)}});
    }
    data["plots"].push_back({{"ylabel", lab.plots[p].ylabel}, {"traces", std::move(traces)}});
  }
  for (const LocatedText& toggle : lab.toggles) {
    const bool on = result != nullptr && std::ranges::count(result->overlays, toggle.text) > 0;
    data["toggles"].push_back({{"name", toggle.text}, {"on", on}});
  }
  return data;
}

}  // namespace mjcourse
