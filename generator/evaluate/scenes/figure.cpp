#include "evaluate/scenes/figure.h"

#include <functional>
#include <string>
#include <utility>

#include "base/cancellation.h"
#include "evaluate/scenes/figure_state.h"
#include "evaluate/scenes/pin.h"
#include "evaluate/scenes/step_count.h"
#include "evaluate/scenes/view.h"
#include "physics/film.h"
#include "process/find_program.h"

namespace mjcourse {
namespace {

// From where `simulation` stands: has `look` look at each frame, until that is false. False
// (reported) where it fails.
bool play_frames(const Figure::Animation& animation, Simulation& simulation, const Bench& bench,
                 const std::function<bool()>& look) {
  const auto all = step_count(simulation.model(), animation.seconds);
  if (!all) {
    return bench.error("E-figure-simulation", animation.span, all.error(), "a larger time step");
  }
  int taken = 0;
  for (int frame = 0; frame < animation.frames(); ++frame) {
    end_if_cancelled();
    const int steps =
        step_count(simulation.model(), static_cast<double>(frame) / animation.rate).value();
    if (!step_on(simulation, steps - taken, animation.span, bench)) return false;
    taken = steps;
    if (!look()) return false;
  }
  return true;
}

// From where `simulation` stands; empty (reported) where that fails.
std::string shoot(const Figure::Animation& animation, Simulation& simulation, View view,
                  const Bench& bench) {
  view.detail = Detail::film;
  Film film(animation.rate);
  const bool played = play_frames(animation, simulation, bench, [&] {
    const auto picture = draw(simulation, view, "the animation", animation.span, bench);
    if (picture) film.add(*picture);
    return picture.has_value();
  });
  if (!played) return "";
  bench.workshop().trace().file(find_program("ffmpeg"));
  auto bytes = film.encode();
  if (bytes) return *std::move(bytes);
  bench.error("E-figure-film", animation.span, bytes.error().message, bytes.error().cure);
  return "";
}

}  // namespace

std::optional<FigureResult> evaluate_figure(const Figure& figure, const Lesson& lesson,
                                            Workshop& workshop, Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.size();
  const Bench bench(lesson, workshop, diagnostics);
  check_overlays(names_of(figure.overlays), bench);
  std::optional<Simulation> simulation = simulate_figure(figure, bench);
  if (!simulation || diagnostics.size() > before) return std::nullopt;
  const Outlook outlook{.aspect = static_cast<double>(figure.width) / figure.height};
  WholeView seen(simulation->model(), outlook);
  if (!figure.camera) seen.add(*simulation);
  if (!figure.camera && figure.animation) {
    const auto look = [&] {
      seen.add(*simulation);
      return true;
    };
    if (!play_frames(*figure.animation, *simulation, bench, look)) return std::nullopt;
    simulation.reset();  // a large model is not there twice
    simulation = simulate_figure(figure, bench);
    if (!simulation) return std::nullopt;
  }
  const View view{camera_of(figure.camera, seen), figure.overlays, figure.width, figure.height};
  const auto picture = draw(*simulation, view, "the figure", figure.span, bench);
  if (!picture) return std::nullopt;
  FigureResult result{poster_of(*picture, view), {}};
  if (figure.animation) {
    result.film = Blob(shoot(*figure.animation, *simulation, view, bench));
  }
  result.pin = compare_pin(figure.pin, *picture, bench);
  return result;
}

}  // namespace mjcourse
