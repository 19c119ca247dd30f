#include "evaluate/scenes/lab.h"

#include <algorithm>
#include <utility>

#include "evaluate/scenes/assignment.h"
#include "evaluate/scenes/lab_memory.h"
#include "evaluate/scenes/lab_model.h"
#include "evaluate/scenes/pin.h"
#include "evaluate/scenes/rehearsal.h"
#include "evaluate/scenes/view.h"

namespace mjcourse {
namespace {

constexpr int kPosterWidth = 712;  // CSS pixels: the widest that a lab gets

// A narrow page cuts the sides off: all is seen in one where the lab is as wide as it is high.
Outlook outlook_of(const Lab& lab) {
  return {.aspect = std::min(1.0, static_cast<double>(kPosterWidth) / lab.height)};
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
bool read_at_start(const Lab& lab, LabRun& run, LabResult& result) {
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

}  // namespace

std::optional<LabResult> rehearse_lab(const Lab& lab, const Lesson& lesson,
                                      WorkerContext& worker_context, Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.size();
  LabResult result;
  DoubtfulScripts doubtful;
  const LabContext context(lab, result.scripts, lesson, worker_context, diagnostics, &doubtful);
  check_overlays(lab.toggles, context);
  check_overlays(names_of(lab.overlays), context);
  if (!guard_scripts(context, result.scripts, doubtful)) return std::nullopt;
  std::optional<LabRun> run = LabRun::start(context, lab.model);
  const auto memory = run ? memory_in_page(context, run->simulation()) : std::nullopt;
  if (!memory) return std::nullopt;
  result.memory = *memory;
  result.script_names = run->world().names();
  result.keyframes = find_keyframes(lab, run->simulation().model());
  const bool read = read_at_start(lab, *run, result);
  // What fails at the start would fail again after every control.
  const bool at_start = check_at_start(context, *run);
  WholeView view(run->simulation().model(), outlook_of(lab));
  run.reset();  // a large model is not there twice
  if (at_start && read) {
    result.runs = rehearse(context, lab.camera ? nullptr : &view);
    evaluate_assignment(context, result);
  }
  if (std::optional<LabModel> model = find_lab_model(context)) result.model = *std::move(model);
  if (diagnostics.size() == before) {
    for (const DoubtfulScript& script : doubtful) context.error(script.error, *script.text);
  }
  if (diagnostics.size() > before) return std::nullopt;
  result.camera = camera_of(lab.camera, view);
  if (const auto options = visual_options(switched(lab.overlays))) {
    result.overlays = overlays_in(*options);
  }
  return result;
}

std::optional<LabResult> evaluate_lab(const Lab& lab, const Lesson& lesson,
                                      WorkerContext& worker_context, Diagnostics& diagnostics) {
  std::optional<LabResult> result = rehearse_lab(lab, lesson, worker_context, diagnostics);
  const LabScripts none;
  const LabContext context(lab, result ? result->scripts : none, lesson, worker_context,
                           diagnostics);
  const std::optional<LabRun> run = result ? LabRun::start(context, lab.model) : std::nullopt;
  if (!run) return std::nullopt;
  const View view{result->camera, lab.overlays, kPosterWidth, lab.height};
  if (const auto picture = draw(run->simulation(), view, "the poster", lab.span, context)) {
    result->poster = poster_of(*picture, view);
    result->pin = compare_pin(lab.pin, *picture, context);
  }
  return result;
}

}  // namespace mjcourse
