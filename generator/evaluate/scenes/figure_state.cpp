#include "evaluate/scenes/figure_state.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/counted.h"
#include "evaluate/scenes/keyframe.h"
#include "evaluate/scenes/step_count.h"
#include "script/world.h"

namespace mjcourse {
namespace {

// A part of a state as an example records it, and where a simulation has it.
struct Part {
  const char* name;
  mjtNum* at;
  int size;
};

std::vector<Part> parts_of(Simulation& simulation) {
  const Model& model = simulation.model();
  Data& data = simulation.data();
  return {{"time", &data->time, 1},
          {"qpos", data->qpos, model->nq},
          {"qvel", data->qvel, model->nv},
          {"act", data->act, model->na},
          {"ctrl", data->ctrl, model->nu},
          {"mocap_pos", data->mocap_pos, 3 * model->nmocap},
          {"mocap_quat", data->mocap_quat, 4 * model->nmocap}};
}

// A simulation that is in trouble, or would be in a moment, is no picture of the lesson's.
bool sound(const Simulation& simulation, Span blamed, const BlockContext& context) {
  const std::optional<Simulation::Trouble>& trouble = simulation.trouble();
  return !trouble || context.error("E-figure-simulation", blamed, trouble->what,
                                   trouble->cure.empty() ? "a smaller time step, or a gentler start"
                                                         : trouble->cure);
}

bool restore(const Figure::Snapshot& from, const Figure& figure, Simulation& simulation,
             const BlockContext& context) {
  const auto state =
      context.worker_context()
          .reports_of(from.example.text)
          .find_snapshot(from.example, from.name, *context.lesson().source, context.diagnostics());
  if (!state) return false;
  for (const Part& part : parts_of(simulation)) {
    const auto found = state->find(part.name);
    const std::vector<double> none;
    const std::vector<double>& numbers = found != state->end() ? found->second : none;
    if (numbers.size() != static_cast<std::size_t>(part.size)) {
      const bool inlined = figure.model.text.starts_with('<');
      return context.error("E-figure-from", from.name.span(),
                           "the snapshot `" + from.name.text + "` is of another model: its " +
                               part.name + " has " + counted(numbers.size(), "number") + ", and " +
                               (inlined ? "this model" : "`" + figure.model.text + "`") +
                               " takes " + std::to_string(part.size),
                           "give the figure the model that the example simulates");
    }
    std::copy(numbers.begin(), numbers.end(), part.at);
  }
  simulation.forward();
  return sound(simulation, from.name.span(), context);
}

bool run_script(const LocatedText& script, Simulation& simulation, const BlockContext& context) {
  World world(context.worker_context().world_bundle(), simulation);
  const auto done = world.run(script.text);
  if (!done) return context.error(done.error(), script);
  simulation.forward();
  return sound(simulation, script.span(), context);
}

bool let_pass(const Figure& figure, Simulation& simulation, const BlockContext& context) {
  if (figure.seconds == 0) return true;
  const auto steps = step_count(simulation.model(), figure.seconds);
  if (!steps) {
    return context.error("E-figure-simulation", figure.seconds_span, steps.error(),
                         "a larger time step");
  }
  return step_on(simulation, *steps, figure.seconds_span, context);
}

}  // namespace

bool step_on(Simulation& simulation, int steps, Span blamed, const BlockContext& context) {
  simulation.step(steps);
  return sound(simulation, blamed, context);
}

std::optional<Simulation> simulate_figure(const Figure& figure, const BlockContext& context) {
  std::optional<Simulation> simulation = context.simulate(figure.model);
  if (!simulation) return std::nullopt;
  const bool good =
      sound(*simulation, figure.model.span(), context) &&
      (!figure.from || restore(*figure.from, figure, *simulation, context)) &&
      (figure.keyframe.text.empty() || reset_to(figure.keyframe, *simulation, context)) &&
      (figure.run.text.empty() || run_script(figure.run, *simulation, context)) &&
      let_pass(figure, *simulation, context);
  return good ? std::move(simulation) : std::nullopt;
}

}  // namespace mjcourse
