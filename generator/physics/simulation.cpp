#include "physics/simulation.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/nearest.h"
#include "physics/divergence.h"
#include "physics/mujoco_guard.h"

namespace mjcourse {
namespace {

constexpr int initial_state = -1;  // in place of a keyframe

std::string at(double time) {
  std::ostringstream text;
  text << " at t = " << time << " s: ";
  return text.str();
}

// A model that states a size of MuJoCo's memory states too small a one.
std::string larger(const std::string& size) {
  return "a larger `" + size + "` in the model's `<size>`, or none: MuJoCo finds one then";
}

std::string cure_of(int warning) {
  switch (warning) {
    case mjWARN_CONTACTFULL:
      return larger("nconmax");
    case mjWARN_CNSTRFULL:
      return larger("njmax");
    case mjWARN_INERTIA:
      return "larger masses and inertias, or an `armature` in the joint";
    default:
      return "";
  }
}

}  // namespace

Simulation::Simulation(Model model) : model_(std::move(model)), data_(model_) {
  begin(initial_state);
}

void Simulation::reset() {
  begin(initial_state);
}

tl::expected<void, std::string> Simulation::reset_to_keyframe(int key) {
  if (key < 0 || key >= model_->nkey) {
    return tl::unexpected("there is no keyframe " + std::to_string(key) + "; the model has " +
                          std::to_string(model_->nkey));
  }
  begin(key);
  return {};
}

tl::expected<void, std::string> Simulation::reset_to_keyframe(const std::string& name) {
  const int key = model_.id(mjOBJ_KEY, name);
  if (key >= 0) return reset_to_keyframe(key);
  return tl::unexpected("there is no keyframe `" + name + "`; " +
                        suggest(name, model_.names(mjOBJ_KEY)));
}

void Simulation::begin(int key) {
  if (key == initial_state) {
    mj_resetData(model_.get(), data_.get());
  } else {
    mj_resetDataKeyframe(model_.get(), data_.get(), key);
  }
  last_time_ = data_->time;
  trouble_.reset();
  stopped_ = false;
  forward();
}

void Simulation::forward() {
  guarded([this] { mj_forward(model_.get(), data_.get()); });
}

void Simulation::step(int n) {
  guarded([this, n] {
    for (int i = 0; i < n && !stopped_; ++i) {
      mj_step(model_.get(), data_.get());
      watch();
    }
  });
}

void Simulation::advance(double seconds) {
  step(static_cast<int>(std::lround(seconds / model_->opt.timestep)));
}

// Does `work` on the data, and turns what MuJoCo has to say about it into trouble.
template <typename Work>
void Simulation::guarded(const Work& work) {
  if (stopped_) return;
  const WarningLog log;
  try {
    work();
    watch();
  } catch (const MujocoError& error) {
    const std::string what = error.what();
    stop("MuJoCo gave up" + at(last_time_) + what,
         what.find("Stack overflow") == what.npos ? "" : larger("nstack"));
  }
  if (!log.warnings().empty()) report("MuJoCo warns: " + log.warnings().front());
}

void Simulation::watch() {
  if (const auto entry = find_divergence(model_, data_)) {
    // Once MuJoCo has reset the data its time is that of the new start.
    stop("the simulation diverged" + at(std::max(last_time_, data_->time)) + *entry +
         " is infinite, not a number, or huge");
  } else if (data_->time < last_time_) {
    stop("the simulation restarted" + at(last_time_) + "its time ran backwards");
  }
  for (int i = 0; i < mjNWARNING; ++i) {
    const mjWarningStat& warning = data_->warning[i];
    if (warning.number > 0) {
      report("MuJoCo warns" + at(data_->time) + mju_warningText(i, warning.lastinfo), cure_of(i));
    }
  }
  last_time_ = data_->time;
}

// The first trouble is the one to mend; what follows from it is not told.
void Simulation::report(std::string what, std::string cure) {
  if (!trouble_) trouble_ = Trouble{std::move(what), std::move(cure)};
}

void Simulation::stop(std::string what, std::string cure) {
  report(std::move(what), std::move(cure));
  stopped_ = true;
}

}  // namespace mjcourse
