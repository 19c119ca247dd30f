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
bool play_frames(const Figure::Animation& animation, Simulation& simulation,
                 const BlockContext& context, const std::function<bool()>& look) {
  const auto all = step_count(simulation.model(), animation.seconds);
  if (!all) {
    return context.error("E-figure-simulation", animation.span, all.error(), "a larger time step");
  }
  int taken = 0;
  for (int frame = 0; frame < animation.frames(); ++frame) {
    end_if_cancelled();
    const int steps =
        step_count(simulation.model(), static_cast<double>(frame) / animation.rate).value();
    if (!step_on(simulation, steps - taken, animation.span, context)) return false;
    taken = steps;
    if (!look()) return false;
  }
  return true;
}

// From where `simulation` stands; empty (reported) where that fails.
std::string shoot(const Figure::Animation& animation, Simulation& simulation, View view,
                  const BlockContext& context) {
  view.detail = Detail::film;
  Film film(animation.rate);
  const bool played = play_frames(animation, simulation, context, [&] {
    const auto picture = draw(simulation, view, "the animation", animation.span, context);
    if (picture) film.add(*picture);
    return picture.has_value();
  });
  if (!played) return "";
  context.worker_context().trace().file(find_program("ffmpeg"));
  auto bytes = film.encode();
  if (bytes) return *std::move(bytes);
  context.error("E-figure-film", animation.span, bytes.error().message, bytes.error().cure);
  return "";
}

}  // namespace

std::optional<FigureResult> evaluate_figure(const Figure& figure, const Lesson& lesson,
                                            WorkerContext& worker_context,
                                            Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.size();
  const BlockContext context(lesson, worker_context, diagnostics);
  check_overlays(names_of(figure.overlays), context);
  std::optional<Simulation> simulation = simulate_figure(figure, context);
  if (!simulation || diagnostics.size() > before) return std::nullopt;
  const Outlook outlook{.aspect = static_cast<double>(figure.width) / figure.height};
  WholeView seen(simulation->model(), outlook);
  if (!figure.camera) seen.add(*simulation);
  if (!figure.camera && figure.animation) {
    const auto look = [&] {
      seen.add(*simulation);
      return true;
    };
    if (!play_frames(*figure.animation, *simulation, context, look)) return std::nullopt;
    simulation.reset();  // a large model is not there twice
    simulation = simulate_figure(figure, context);
    if (!simulation) return std::nullopt;
  }
  const View view{camera_of(figure.camera, seen), figure.overlays, figure.width, figure.height};
  const auto picture = draw(*simulation, view, "the figure", figure.span, context);
  if (!picture) return std::nullopt;
  FigureResult result{poster_of(*picture, view), {}};
  if (figure.animation) {
    result.film = Blob(shoot(*figure.animation, *simulation, view, context));
  }
  result.pin = compare_pin(figure.pin, *picture, context);
  return result;
}

}  // namespace mjcourse
