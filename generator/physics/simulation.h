// A model in motion, watched.
//
// A simulation that diverges does not stop in MuJoCo: it warns once, resets itself and goes on from
// the start, and whatever is measured afterwards is a lie. Simulation steps one step at a time,
// looks after each, and stops; trouble() then says in plain words what happened and when.
//
// Always holds: after the constructor, reset() and reset_to_keyframe(), mj_forward has been done.
#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "physics/data.h"
#include "physics/model.h"

namespace mjcourse {

class Simulation {
 public:
  explicit Simulation(Model model);

  Model& model() { return model_; }
  const Model& model() const { return model_; }
  Data& data() { return data_; }
  const Data& data() const { return data_; }

  // Back to the model's initial state; trouble is forgotten.
  void reset();
  // The same, to a keyframe; the error names the keyframes there are.
  tl::expected<void, std::string> reset_to_keyframe(int key);
  tl::expected<void, std::string> reset_to_keyframe(const std::string& name);

  // mj_forward: everything that follows from the state, without a step in time.
  void forward();
  // `n` times mj_step. Does nothing more once the simulation has stopped().
  void step(int n = 1);
  // As many steps as come nearest to `seconds` of simulated time.
  void advance(double seconds);

  // What went wrong, and what MuJoCo would have done about it: "" where the caller knows better.
  struct Trouble {
    std::string what, cure;
  };
  // The first thing that went wrong since the last reset: a divergence, or a warning of MuJoCo's.
  const std::optional<Trouble>& trouble() const { return trouble_; }
  // Has it diverged, or met an error of MuJoCo's? Its state is then worth nothing until a reset.
  bool stopped() const { return stopped_; }
  // Look for trouble now. Call it after mj_step or mj_forward on data() from elsewhere.
  void watch();

 private:
  template <typename Work>
  void guarded(const Work& work);
  void begin(int key);
  void report(std::string what, std::string cure = "");
  void stop(std::string what, std::string cure = "");

  Model model_;
  Data data_;
  double last_time_ = 0;  // data's time when last looked at, in seconds
  std::optional<Trouble> trouble_;
  bool stopped_ = false;
};

}  // namespace mjcourse
