// Results as JSON values, and back. Only the store's codec and the messages of workers include
// this, since it takes long to compile.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

#include "findings/finding.h"
#include "lesson/lesson_of_lab.h"

// How the library reads and writes what the standard library has and JSON has not.
namespace nlohmann {

template <typename T>
struct adl_serializer<std::optional<T>> {
  static void to_json(json& j, const std::optional<T>& value) {
    j = value ? json::array({*value}) : json::array();
  }
  static void from_json(const json& j, std::optional<T>& value) {
    value = j.empty() ? std::nullopt : std::optional<T>(j.at(0).template get<T>());
  }
};

// As the index of the alternative and its value, of which std::monostate has none.
template <typename... Ts>
struct adl_serializer<std::variant<Ts...>> {
  static void to_json(json& j, const std::variant<Ts...>& value) {
    const auto put = [&](const auto& known) {
      j = json::array({value.index(), nullptr});
      if constexpr (!std::is_empty_v<std::decay_t<decltype(known)>>) j[1] = known;
    };
    std::visit(put, value);
  }
  static void from_json(const json& j, std::variant<Ts...>& value) {
    std::size_t index = 0;
    const auto take = [&](auto* of_type) {
      using T = std::remove_pointer_t<decltype(of_type)>;
      if (index++ != j.at(0)) return;
      if constexpr (std::is_empty_v<T>) {
        value = T();
      } else {
        value = j.at(1).get<T>();
      }
    };
    (take(static_cast<Ts*>(nullptr)), ...);
  }
};

template <>
struct adl_serializer<std::filesystem::path> {
  static void to_json(json& j, const std::filesystem::path& path) { j = path.string(); }
  static void from_json(const json& j, std::filesystem::path& path) { path = j.get<std::string>(); }
};

template <>
struct adl_serializer<mjcourse::Blob> {
  static void to_json(json& j, const mjcourse::Blob& blob) { j = blob.hash(); }
  static void from_json(const json& j, mjcourse::Blob& blob) {
    blob = mjcourse::Blob::known(j.get<std::string>());
  }
};

}  // namespace nlohmann

namespace mjcourse {

// Each structure as the list of its members; one that is forgotten here is lost on the way, which
// the codec's test sees.
#define MJCOURSE_FIELDS NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE
MJCOURSE_FIELDS(FormulaResult, markup)
MJCOURSE_FIELDS(Column, name, values)
MJCOURSE_FIELDS(Check, what, holds, meaning, found, points, line)
MJCOURSE_FIELDS(Records, results, tables, snapshots, checks)
MJCOURSE_FIELDS(PageRun::Outputs, native, page)
MJCOURSE_FIELDS(PageRun, why_not, outputs, otherwise)
MJCOURSE_FIELDS(ExampleResult, code, output, records, run_seconds, files, page)
MJCOURSE_FIELDS(ExerciseResult::Trial, name, fails)
MJCOURSE_FIELDS(ExerciseResult, starter, trials, hidden, why_not, checks, files, page)
MJCOURSE_FIELDS(ValueResult, text, origin)
MJCOURSE_FIELDS(ModelResult, refusal)
MJCOURSE_FIELDS(ImageResult, file, hash, width, height)
MJCOURSE_FIELDS(OutputResult, lines)
MJCOURSE_FIELDS(Poster, webp, png, width, height)
MJCOURSE_FIELDS(PinComparison, name, reference, actual, difference, agrees)
MJCOURSE_FIELDS(FigureResult, poster, film, pin)
MJCOURSE_FIELDS(LabModel, main, texts, assets)
MJCOURSE_FIELDS(LabReading, steps, values, ghost)
MJCOURSE_FIELDS(LabRunResult, control, value, readings)
MJCOURSE_FIELDS(Lab::Camera, azimuth, elevation, distance, target)
MJCOURSE_FIELDS(LabResult, readouts, traces, camera, overlays, memory, model, script_names, scripts,
                keyframes, runs, predicted, poster, pin)
MJCOURSE_FIELDS(PlotDrawing, svg, width, height)
MJCOURSE_FIELDS(PlotDrawings, wide, narrow)
MJCOURSE_FIELDS(PlotResult, drawings, table, file)
MJCOURSE_FIELDS(ProofResult, built, expression, value)
MJCOURSE_FIELDS(QuestionResult, proved, proofs, by_program, because, failed, seconds)
MJCOURSE_FIELDS(QuizResult, questions)
MJCOURSE_FIELDS(ModelPage::Range, first, count)
MJCOURSE_FIELDS(ModelPage::Joint, name, type, body, qpos, dof, limits)
MJCOURSE_FIELDS(ModelPage::Actuator, name, on, limits)
MJCOURSE_FIELDS(ModelPage::Sensor, name, of, data)
MJCOURSE_FIELDS(ModelPage::Keyframe, name, time)
MJCOURSE_FIELDS(ModelPage::File, path, text)
// By its fence, which is parsed here and nowhere else but where it was written.
inline void to_json(nlohmann::json& j, const ModelPage::LiveLab& lab) {
  j = {
      {"model", lab.lesson->number}, {"fence", lab.lesson->source->text()}, {"result", lab.result}};
}
inline void from_json(const nlohmann::json& j, ModelPage::LiveLab& lab) {
  lab.lesson = lesson_of_lab(j.at("model").get<std::string>(), j.at("fence").get<std::string>());
  j.at("result").get_to(lab.result);
}
MJCOURSE_FIELDS(ModelPage, name, sizes, timestep, joints, actuators, sensors, keyframes, files,
                poster, lab)
#undef MJCOURSE_FIELDS

}  // namespace mjcourse
