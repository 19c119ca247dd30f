#include "evaluate/scenes/lab_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/cancellation.h"
#include "evaluate/scenes/keyframe.h"
#include "evaluate/scenes/step_count.h"

namespace mjcourse {
namespace {

// The script of the author's that makes the control do its work; empty for a slider and a keyframe.
struct ScriptOf {
  const ControlValue& value;
  LocatedText operator()(const Lab::Button& button) const { return button.run; }
  LocatedText operator()(const Lab::Slider&) const { return {}; }
  LocatedText operator()(const Lab::Toggle& toggle) const {
    return std::get<bool>(value) ? toggle.on : toggle.off;
  }
  LocatedText operator()(const Lab::Select& select) const {
    return select.options[static_cast<std::size_t>(std::get<int>(value))].run;
  }
  LocatedText operator()(const Lab::Keyframe&) const { return {}; }
};

// The text in the lesson that the control's work comes from.
Span span_of(const Lab::Control& control, const ControlValue& value) {
  if (const auto* slider = std::get_if<Lab::Slider>(&control)) return slider->bind.span();
  if (const auto* keyframe = std::get_if<Lab::Keyframe>(&control)) return keyframe->key.span();
  const LocatedText script = std::visit(ScriptOf{value}, control);
  if (!script.text.empty()) return script.span();
  return std::visit([](const auto& any) { return any.label.span(); }, control);
}

// What a reset sets a control to; nothing where it leaves it alone.
struct ValueAtStart {
  using Value = std::optional<ControlValue>;
  Value operator()(const Lab::Button&) const { return {}; }
  Value operator()(const Lab::Slider& slider) const {
    return slider.value ? Value(*slider.value) : Value();
  }
  Value operator()(const Lab::Toggle& toggle) const { return toggle.value ? Value(true) : Value(); }
  Value operator()(const Lab::Select& select) const {
    return select.has_value ? Value(static_cast<int>(select.value)) : Value();
  }
  Value operator()(const Lab::Keyframe&) const { return {}; }
};

}  // namespace

LabRun::Actor::Actor(const LabContext& context, Simulation loaded)
    : simulation(std::move(loaded)), world(context.worker_context().world_bundle(), simulation) {}

std::unique_ptr<LabRun::Actor> LabRun::load(const LabContext& context, const LocatedText& model) {
  std::optional<Simulation> simulation = context.simulate(model);
  if (!simulation) return nullptr;
  return std::make_unique<Actor>(context, *std::move(simulation));
}

std::optional<LabRun> LabRun::start(const LabContext& context, const LocatedText& model) {
  LabRun run(context, load(context, model));
  if (!run.main_) return std::nullopt;
  run.blamed_ = context.lab().span;
  if (&model != &context.lab().model) run.solution_ = &model;
  if (!run.begin(*run.main_)) return std::nullopt;
  if (context.lab().ghost) {
    run.ghost_ = load(context, model);
    const bool begun = run.ghost_ && run.begin(*run.ghost_) &&
                       run.run(*run.ghost_, context.lab().ghost->run) && run.forward(*run.ghost_);
    if (!begun) return std::nullopt;
  }
  run.after_ = "Play";
  return run;
}

// The lab's definitions by themselves, or each script behind them would be blamed for a bracket
// that they leave open.
bool LabRun::define(Actor& actor) {
  const LocatedText& define = context_.lab().define;
  if (define.text.empty()) return true;
  const auto done = actor.world.run(context_.guarded(define, ScriptKind::definitions));
  return done || context_.error(done.error(), define, ScriptKind::definitions, nullptr);
}

bool LabRun::begin(Actor& actor) {
  if (!define(actor)) return false;
  bool any = false;
  for (const Lab::Control& control : context_.lab().controls) {
    const auto value = std::visit(ValueAtStart{}, control);
    if (!value) continue;
    any = true;
    if (!apply(actor, control, *value)) return false;
  }
  return !any || forward(actor);
}

bool LabRun::act(const Lab::Control& control, const ControlValue& value) {
  after_ = std::visit([](const auto& any) { return "\"" + any.label.text + "\""; }, control);
  blamed_ = span_of(control, value);
  cure_ = "a smaller time step, or a gentler push";
  if (!apply(*main_, control, value) || !forward(*main_)) return false;
  return !ghost_ || (apply(*ghost_, control, value) && forward(*ghost_));
}

bool LabRun::script(const LocatedText& text, const std::string& what) {
  after_ = what;
  blamed_ = text.span();
  cure_ = "a smaller time step, or a gentler push";
  if (!run(*main_, text) || !forward(*main_)) return false;
  return !ghost_ || (run(*ghost_, text) && forward(*ghost_));
}

bool LabRun::apply(Actor& actor, const Lab::Control& control, const ControlValue& value) {
  if (const auto* slider = std::get_if<Lab::Slider>(&control)) {
    auto set = actor.world.assign(context_.guarded(slider->bind, ScriptKind::assignment),
                                  std::get<double>(value));
    if (set) return true;
    if (set.error().id == "E-script-value" && set.error().cure.empty()) {
      set.error().cure = "choose \"min\", \"max\" and \"step\" so that every value fits";
    }
    return context_.error(set.error(), slider->bind, ScriptKind::assignment, solution_);
  }
  if (const auto* keyframe = std::get_if<Lab::Keyframe>(&control)) {
    return reset_to(keyframe->key, actor.simulation, context_);
  }
  return run(actor, std::visit(ScriptOf{value}, control));
}

bool LabRun::run(Actor& actor, const LocatedText& text) {
  const auto done = actor.world.run(context_.guarded(text, ScriptKind::script));
  return done || context_.error(done.error(), text, ScriptKind::script, solution_);
}

bool LabRun::forward(Actor& actor) {
  actor.simulation.forward();
  return sound(actor);
}

bool LabRun::sound(const Actor& actor) const {
  const std::optional<Simulation::Trouble>& trouble = actor.simulation.trouble();
  if (!trouble) return true;
  const bool of_ghost = &actor == ghost_.get();
  return context_.error(
      "E-lab-simulation", of_ghost ? context_.lab().ghost->run.span() : blamed_,
      (of_ghost ? "in the ghost, after " : "after ") + after_ + ": " + trouble->what,
      trouble->cure.empty() ? cure_ : trouble->cure);
}

std::optional<int> LabRun::steps_in(double seconds) const {
  const auto steps = step_count(main_->simulation.model(), seconds);
  if (steps) return *steps;
  context_.error("E-lab-simulation", blamed_, "after " + after_ + ": " + steps.error(),
                 "a larger time step");
  return std::nullopt;
}

bool LabRun::step_to(int steps) {
  end_if_cancelled();
  main_->simulation.step(steps - steps_);
  steps_ = steps;
  return sound(*main_) && (!ghost_ || follow());
}

// The ghost comes as near to the first simulation's time as its own steps allow.
bool LabRun::follow() {
  Simulation& ghost = ghost_->simulation;
  const double half = ghost.model()->opt.timestep / 2;
  const double until = main_->simulation.data()->time - half;
  for (int steps = 0; half > 0 && steps < kMostSteps && ghost.data()->time < until; ++steps) {
    ghost.step();
    if (!sound(*ghost_)) return false;
  }
  if (ghost.data()->time >= until) return true;
  return context_.error("E-lab-simulation", context_.lab().ghost->run.span(),
                        "the ghost cannot keep up: its time step is too small",
                        "a larger time step");
}

bool LabRun::number(const LocatedText& expression, double& value) {
  const auto found = main_->world.number(context_.guarded(expression, ScriptKind::value));
  if (!found) return context_.error(found.error(), expression, ScriptKind::value, solution_);
  value = *found;
  return true;
}

bool LabRun::truth(const LocatedText& expression, bool& value) {
  const auto found = main_->world.truth(context_.guarded(expression, ScriptKind::value));
  if (!found) return context_.error(found.error(), expression, ScriptKind::value, solution_);
  value = *found;
  return true;
}

bool LabRun::read(std::vector<double>& readouts) {
  const Lab& lab = context_.lab();
  readouts.resize(lab.readouts.size());
  for (std::size_t i = 0; i < readouts.size(); ++i) {
    if (!number(lab.readouts[i].expression, readouts[i])) return false;
  }
  double ignored = 0;
  ghost_traces_.clear();
  for (const Lab::Plot& plot : lab.plots) {
    for (const Lab::Readout& trace : plot.traces) {
      if (!number(trace.expression, ignored)) return false;
      if (!ghost_) continue;
      const auto found =
          ghost_->world.number(context_.guarded(trace.expression, ScriptKind::value));
      if (!found) {
        return context_.error(found.error(), trace.expression, ScriptKind::value, solution_);
      }
      ghost_traces_.push_back(*found);
    }
  }
  bool done = false;
  return !lab.goal || truth(lab.goal->done, done);
}

}  // namespace mjcourse
