#include "evaluate/lab.h"

#include <algorithm>
#include <utility>

#include "base/nearest.h"
#include "evaluate/assignment.h"
#include "evaluate/lab_model.h"
#include "evaluate/rehearsal.h"

namespace mjcourse {
namespace {

constexpr int kPosterWidth = 712;  // CSS pixels: the widest that a lab gets

void check_overlays(const LabBench& bench) {
  std::vector<LocatedText> names = bench.lab().toggles;
  for (const Lab::Overlay& overlay : bench.lab().overlays) names.push_back(overlay.name);
  const std::vector<std::string> known = overlay_names();
  for (const LocatedText& name : names) {
    if (std::find(known.begin(), known.end(), name.text) != known.end()) continue;
    bench.error("E-lab-overlay", name.span(), "there is no overlay \"" + name.text + "\"",
                suggest(name.text, known));
  }
}

std::vector<int> find_keyframes(const Lab& lab, const Model& model) {
  std::vector<int> ids;
  for (const Lab::Control& control : lab.controls) {
    const auto* keyframe = std::get_if<Lab::Keyframe>(&control);
    ids.push_back(keyframe != nullptr ? model.id(mjOBJ_KEY, keyframe->key.text) : 0);
  }
  return ids;
}

// Every readout is read even when one fails: their mistakes are shown together.
bool read_at_rest(const Lab& lab, LabRun& run, LabResult& result) {
  bool good = true;
  for (const Lab::Readout& readout : lab.readouts) {
    good = run.number(readout.expression, result.readouts.emplace_back()) && good;
  }
  for (const Lab::Plot& plot : lab.plots) {
    std::vector<double>& traces = result.traces.emplace_back();
    for (const Lab::Readout& trace : plot.traces) {
      good = run.number(trace.expression, traces.emplace_back()) && good;
    }
  }
  return good;
}

// Without one of the author's, all of the model is seen.
Lab::Camera camera_of(const Lab& lab, const Model& model) {
  const mjStatistic& seen = model->stat;
  return lab.camera.value_or(
      Lab::Camera{90, -45, 1.5 * seen.extent, {seen.center[0], seen.center[1], seen.center[2]}});
}

std::optional<Poster> draw(const LabBench& bench, const Simulation& simulation,
                           const Lab::Camera& camera) {
  const Lab& lab = bench.lab();
  const tl::expected<Renderer*, std::string> renderer = bench.workshop().renderer();
  if (!renderer) {
    bench.error("E-picture", lab.span, "no picture can be drawn: " + renderer.error());
    return std::nullopt;
  }
  Overlays overlays;
  for (const Lab::Overlay& overlay : lab.overlays) overlays[overlay.name.text] = overlay.on;
  const tl::expected<Picture, std::string> picture = (*renderer)->render(
      simulation, {camera.azimuth, camera.elevation, camera.distance, camera.target}, overlays,
      {2 * kPosterWidth, 2 * lab.height});
  if (!picture) {
    bench.error("E-picture", lab.span, "the poster cannot be drawn: " + picture.error());
    return std::nullopt;
  }
  return Poster{encode_webp(*picture), encode_png(*picture), kPosterWidth, lab.height};
}

}  // namespace

std::optional<LabResult> evaluate_lab(const Lab& lab, const Lesson& lesson, Workshop& workshop,
                                      Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.size();
  const LabBench bench(lab, lesson, workshop, diagnostics);
  check_overlays(bench);
  std::optional<LabRun> run = LabRun::start(bench, lab.model);
  if (!run) return std::nullopt;
  LabResult result;
  result.script_names = run->world().names();
  result.keyframes = find_keyframes(lab, run->simulation().model());
  const bool read = read_at_rest(lab, *run, result);
  // What fails at rest would fail again after every control.
  if (check_at_rest(bench, *run) && read) {
    result.runs = rehearse(bench);
    evaluate_assignment(bench, result);
  }
  if (std::optional<LabModel> model = find_lab_model(bench)) result.model = *std::move(model);
  if (diagnostics.size() > before) return std::nullopt;
  result.camera = camera_of(lab, run->simulation().model());
  result.poster = draw(bench, run->simulation(), result.camera);
  return result;
}

}  // namespace mjcourse
