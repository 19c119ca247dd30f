// LabRun: one run of a lab, step for step what the page does.
//
// start() resets and applies the controls that have a value from the start; act() and script() are
// followed by forward(); step_to() is mj_step and nothing else. With a ghost there is a second
// simulation, which takes part in everything. Whatever fails is reported, and the method gives
// false; the run must not be used then.
// Tested by tests/generator/evaluate/scenes/rehearsal_test.cpp.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "evaluate/scenes/lab_context.h"
#include "findings/result.h"
#include "script/world.h"

namespace mjcourse {

class LabRun {
 public:
  // Each run loads `model` anew: scripts may change a model too.
  static std::optional<LabRun> start(const LabContext& context, const LocatedText& model);

  bool act(const Lab::Control& control, const ControlValue& value);
  // `what` names the script where it leads to trouble: "the solution".
  bool script(const LocatedText& text, const std::string& what);

  // How many steps come nearest to `seconds`; nothing (reported) where these are too many.
  std::optional<int> steps_in(double seconds) const;
  // Go on until this many steps were taken since the start.
  bool step_to(int steps);

  bool number(const LocatedText& expression, double& value);
  bool truth(const LocatedText& expression, bool& value);
  // All that the page reads at every frame; `readouts` gets those of the readouts.
  bool read(std::vector<double>& readouts);
  // Then: what the plots' traces are of the ghost, one plot after the other; none without a ghost.
  const std::vector<double>& ghost_traces() const { return ghost_traces_; }

  const Simulation& simulation() const { return main_->simulation; }
  const World& world() const { return main_->world; }

 private:
  struct Actor {  // stays where it is: the world looks into the simulation
    Actor(const LabContext& context, Simulation loaded);
    Simulation simulation;
    World world;
  };

  LabRun(const LabContext& context, std::unique_ptr<Actor> main)
      : context_(context), main_(std::move(main)) {}

  // Null (reported) where the model does not compile.
  static std::unique_ptr<Actor> load(const LabContext& context, const LocatedText& model);
  bool begin(Actor& actor);
  bool define(Actor& actor);
  bool apply(Actor& actor, const Lab::Control& control, const ControlValue& value);
  bool run(Actor& actor, const LocatedText& text);
  bool forward(Actor& actor);
  bool follow();
  bool sound(const Actor& actor) const;

  const LabContext& context_;
  std::unique_ptr<Actor> main_, ghost_;
  std::vector<double> ghost_traces_;
  const LocatedText* solution_ = nullptr;  // the model, where it is not the lab's own
  int steps_ = 0;
  // What the run does, and where to point when it goes wrong.
  std::string after_ = "the reset";
  Span blamed_{};
  std::string cure_ = "a smaller time step";
};

}  // namespace mjcourse
