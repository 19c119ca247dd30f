#include "evaluate/lab.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/nearest.h"
#include "evaluate/script_place.h"
#include "script/world.h"

namespace mjcourse {
namespace {

constexpr double kRehearsal = 2;     // seconds simulated after each control
constexpr double kFrame = 1.0 / 60;  // seconds between two readings, as in the page
constexpr double kScriptLimit = 5;   // seconds of CPU time for one script
constexpr PictureSize kPoster{960, 600};

class Rehearsal {
 public:
  Rehearsal(const Lab& lab, const Lesson& lesson, Workshop& workshop, Diagnostics& diagnostics)
      : lab_(lab), lesson_(lesson), workshop_(workshop), diagnostics_(diagnostics) {}

  std::optional<LabResult> run();

 private:
  void check_names(const std::vector<LocatedText>& names);
  bool rest(Simulation& simulation, LabResult& result);
  bool play(const Lab::Button* button);
  bool read(World& world, const Lab::Readout& readout, double& value);
  bool read_all(World& world);
  std::optional<Poster> draw(Simulation& simulation);
  void error(std::string id, Span span, std::string message, std::string cure = "") {
    diagnostics_.push_back(error_at(place_of(*lesson_.source, span), std::move(id),
                                    std::move(message), std::move(cure)));
  }
  bool script_error(const ScriptError& error, const LocatedText& script) {
    diagnostics_.push_back(script_diagnostic(error, script, *lesson_.source));
    return false;
  }

  const Lab& lab_;
  const Lesson& lesson_;
  Workshop& workshop_;
  Diagnostics& diagnostics_;
};

void Rehearsal::check_names(const std::vector<LocatedText>& names) {
  const std::vector<std::string> known = overlay_names();
  for (const LocatedText& name : names) {
    if (std::find(known.begin(), known.end(), name.text) != known.end()) continue;
    error("E-lab-overlay", name.span(), "there is no overlay \"" + name.text + "\"",
          suggest(name.text, known));
  }
}

bool Rehearsal::read(World& world, const Lab::Readout& readout, double& value) {
  const tl::expected<double, ScriptError> number = world.number(readout.expression.text);
  if (!number) return script_error(number.error(), readout.expression);
  value = *number;
  return true;
}

bool Rehearsal::read_all(World& world) {
  double ignored = 0;
  const auto reads = [&](const Lab::Readout& readout) { return read(world, readout, ignored); };
  return std::all_of(lab_.readouts.begin(), lab_.readouts.end(), reads) &&
         std::all_of(lab_.plots.begin(), lab_.plots.end(), [&](const Lab::Plot& plot) {
           return std::all_of(plot.traces.begin(), plot.traces.end(), reads);
         });
}

// Every readout is read even when one fails: their mistakes are shown together.
bool Rehearsal::rest(Simulation& simulation, LabResult& result) {
  World world(workshop_.world_bundle(), simulation, kScriptLimit);
  bool good = true;
  for (const Lab::Readout& readout : lab_.readouts) {
    good = read(world, readout, result.readouts.emplace_back()) && good;
  }
  for (const Lab::Plot& plot : lab_.plots) {
    std::vector<double>& traces = result.traces.emplace_back();
    for (const Lab::Readout& trace : plot.traces) {
      good = read(world, trace, traces.emplace_back()) && good;
    }
  }
  return good;
}

// Two seconds on from a fresh state, on which `button` was pressed if there is one.
bool Rehearsal::play(const Lab::Button* button) {
  std::optional<Simulation> simulation =
      workshop_.simulate(lab_.model, *lesson_.source, diagnostics_);
  if (!simulation) return false;
  World world(workshop_.world_bundle(), *simulation, kScriptLimit);
  if (button != nullptr) {
    const auto done = world.run(button->run.text);
    if (!done) return script_error(done.error(), button->run);
  }
  // A model may take steps longer than a frame.
  const double pause = std::max(kFrame, simulation->model()->opt.timestep);
  const int pauses = static_cast<int>(std::ceil(kRehearsal / pause));
  for (int i = 0; i < pauses; ++i) {
    simulation->advance(pause);
    if (simulation->trouble()) {
      error("E-lab-simulation", button != nullptr ? button->run.span() : lab_.span,
            "after " +
                (button != nullptr ? "\"" + button->label.text + "\"" : std::string("Play")) +
                ": " + *simulation->trouble(),
            button != nullptr ? "a smaller time step, or a gentler push" : "a smaller time step");
      return false;
    }
    if (!read_all(world)) return false;
  }
  return true;
}

std::optional<Poster> Rehearsal::draw(Simulation& simulation) {
  const tl::expected<Renderer*, std::string> renderer = workshop_.renderer();
  if (!renderer) {
    error("E-picture", lab_.span, "no picture can be drawn: " + renderer.error());
    return std::nullopt;
  }
  const mjStatistic& extent = simulation.model()->stat;
  const Lab::Camera camera = lab_.camera.value_or(Lab::Camera{
      90, -45, 1.5 * extent.extent, {extent.center[0], extent.center[1], extent.center[2]}});
  Overlays overlays;
  for (const Lab::Overlay& overlay : lab_.overlays) overlays[overlay.name.text] = overlay.on;
  const tl::expected<Picture, std::string> picture = (*renderer)->render(
      simulation, {camera.azimuth, camera.elevation, camera.distance, camera.target}, overlays,
      kPoster);
  if (!picture) {
    error("E-picture", lab_.span, "the poster cannot be drawn: " + picture.error());
    return std::nullopt;
  }
  return Poster{encode_webp(*picture), encode_png(*picture), picture->width, picture->height};
}

std::optional<LabResult> Rehearsal::run() {
  const std::size_t before = diagnostics_.size();
  std::vector<LocatedText> overlays = lab_.toggles;
  for (const Lab::Overlay& overlay : lab_.overlays) overlays.push_back(overlay.name);
  check_names(overlays);
  std::optional<Simulation> simulation =
      workshop_.simulate(lab_.model, *lesson_.source, diagnostics_);
  if (!simulation) return std::nullopt;
  LabResult result;
  // What fails at rest, or by itself, would fail again after every button.
  if (rest(*simulation, result) && play(nullptr)) {
    for (const Lab::Button& button : lab_.controls) play(&button);
  }
  if (diagnostics_.size() > before) return std::nullopt;
  result.poster = draw(*simulation);
  return result;
}

}  // namespace

std::optional<LabResult> evaluate_lab(const Lab& lab, const Lesson& lesson, Workshop& workshop,
                                      Diagnostics& diagnostics) {
  return Rehearsal(lab, lesson, workshop, diagnostics).run();
}

}  // namespace mjcourse
