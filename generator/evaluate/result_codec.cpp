#include "evaluate/result_codec.h"

#include <nlohmann/json.hpp>
#include <utility>
#include <variant>
#include <vector>

#include "base/sha256.h"

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

// As the index of the alternative and its value.
template <typename... Ts>
struct adl_serializer<std::variant<Ts...>> {
  static void to_json(json& j, const std::variant<Ts...>& value) {
    std::visit([&](const auto& known) { j = json::array({value.index(), known}); }, value);
  }
  static void from_json(const json& j, std::variant<Ts...>& value) {
    std::size_t index = 0;
    const auto take = [&](auto* of_type) {
      if (index++ == j.at(0)) value = j.at(1).get<std::remove_pointer_t<decltype(of_type)>>();
    };
    (take(static_cast<Ts*>(nullptr)), ...);
  }
};

template <>
struct adl_serializer<std::monostate> {
  static void to_json(json& j, const std::monostate&) { j = nullptr; }
  static void from_json(const json&, std::monostate&) {}
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

using nlohmann::json;

// Each structure as the list of its members; one that is forgotten here is lost on the way, which
// the codec's test sees.
#define MJCOURSE_FIELDS NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE
MJCOURSE_FIELDS(FormulaResult, markup)
MJCOURSE_FIELDS(Column, name, values)
MJCOURSE_FIELDS(Records, results, tables, snapshots)
MJCOURSE_FIELDS(ExampleResult, code, output, records, run_seconds, files)
MJCOURSE_FIELDS(ValueResult, text, origin)
MJCOURSE_FIELDS(ModelResult, refusal)
MJCOURSE_FIELDS(ImageResult, file, hash, width, height)
MJCOURSE_FIELDS(OutputResult, lines)
MJCOURSE_FIELDS(Poster, webp, png, width, height)
MJCOURSE_FIELDS(PinComparison, name, reference, actual, difference, agrees)
MJCOURSE_FIELDS(FigureResult, poster, film, pin)
MJCOURSE_FIELDS(LabModel, main, texts, assets)
MJCOURSE_FIELDS(LabReading, steps, values)
MJCOURSE_FIELDS(LabRunResult, control, value, readings)
MJCOURSE_FIELDS(Lab::Camera, azimuth, elevation, distance, target)
MJCOURSE_FIELDS(LabResult, readouts, traces, camera, model, script_names, keyframes, runs,
                predicted, poster, pin)
MJCOURSE_FIELDS(ChartDrawing, svg, width, height)
MJCOURSE_FIELDS(ChartDrawings, wide, narrow)
MJCOURSE_FIELDS(ChartResult, drawings, table, file)
MJCOURSE_FIELDS(ProofResult, built, expression, value)
MJCOURSE_FIELDS(QuestionResult, proved, proofs, by_program, because, failed, seconds)
MJCOURSE_FIELDS(QuizResult, questions)
MJCOURSE_FIELDS(ModelPage::Range, first, count)
MJCOURSE_FIELDS(ModelPage::Joint, name, type, body, qpos, dof, limits)
MJCOURSE_FIELDS(ModelPage::Actuator, name, on, limits)
MJCOURSE_FIELDS(ModelPage::Sensor, name, of, data)
MJCOURSE_FIELDS(ModelPage::Keyframe, name, time)
MJCOURSE_FIELDS(ModelPage::File, path, text)
MJCOURSE_FIELDS(ModelPage::LiveLab, fence, result)
MJCOURSE_FIELDS(ModelPage, name, sizes, timestep, joints, actuators, sensors, keyframes, files,
                poster, lab)
#undef MJCOURSE_FIELDS

namespace {

namespace fs = std::filesystem;

struct BlobsOf {
  std::vector<Blob*>& found;

  void operator()(Poster& poster) { found.insert(found.end(), {&poster.webp, &poster.png}); }
  void operator()(std::optional<Poster>& poster) {
    if (poster) (*this)(*poster);
  }
  void operator()(std::optional<PinComparison>& pin) {
    if (pin) found.insert(found.end(), {&pin->reference, &pin->actual, &pin->difference});
  }
  void operator()(FigureResult& figure) {
    (*this)(figure.poster);
    found.push_back(&figure.film);
    (*this)(figure.pin);
  }
  void operator()(LabResult& lab) {
    (*this)(lab.poster);
    (*this)(lab.pin);
  }
  template <typename Other>
  void operator()(Other&) {}
};

// Paths below the course's folder, and back; others are the system's, and the same everywhere.
template <typename Change>
void change_paths(Finding& finding, const Change& change) {
  const auto change_lab = [&](LabResult& lab) {
    for (auto& [name, path] : lab.model.assets) path = change(path);
  };
  for (auto& [block, result] : finding.results) {
    if (auto* lab = std::get_if<LabResult>(&result)) change_lab(*lab);
  }
  if (finding.model_page && finding.model_page->lab) change_lab(finding.model_page->lab->result);
}

}  // namespace

bool ResultCodec::keep_blobs(Finding& finding) const {
  std::vector<Blob*> blobs;
  BlobsOf collect{blobs};
  for (auto& [block, result] : finding.results) std::visit(collect, result);
  if (finding.model_page) collect(finding.model_page->poster);
  for (Blob* blob : blobs) {
    if (!blob->keep_in(store_)) return false;
  }
  return true;
}

std::optional<std::string> ResultCodec::encode(Finding& finding, std::size_t first) const {
  if (!keep_blobs(finding)) return std::nullopt;
  change_paths(finding, [&](const fs::path& path) {
    const fs::path below = path.lexically_relative(root_);
    return below.empty() || *below.begin() == ".." ? path : below;
  });
  json results = json::array();
  for (const auto& [block, result] : finding.results) {
    const auto seconds = finding.seconds.find(block);
    results.push_back(
        {block - first, result, seconds == finding.seconds.end() ? 0 : seconds->second});
  }
  const std::vector<std::uint8_t> bytes =
      json::to_cbor({{"results", std::move(results)}, {"model", finding.model_page}});
  change_paths(finding, [&](const fs::path& path) { return root_ / path; });
  return std::string(bytes.begin(), bytes.end());
}

std::optional<Finding> ResultCodec::decode(const std::string& bytes, std::size_t first) const {
  Finding finding;
  try {
    const json all = json::from_cbor(bytes);
    for (const json& one : all.at("results")) {
      const std::size_t block = first + one.at(0).get<std::size_t>();
      finding.results[block] = one.at(1).get<Result>();
      finding.seconds[block] = one.at(2).get<double>();
    }
    finding.model_page = all.at("model").get<std::optional<ModelPage>>();
  } catch (const json::exception&) {
    return std::nullopt;  // whatever it is, it is no finding
  }
  change_paths(finding, [&](const fs::path& path) { return root_ / path; });
  return keep_blobs(finding) ? std::optional(std::move(finding)) : std::nullopt;
}

std::string fingerprint_of(const Records& records) {
  const std::vector<std::uint8_t> bytes = json::to_cbor(records);
  return sha256({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace mjcourse
