// Lesson 1.3: what a smaller step buys from each integrator, and what it costs.
//
// INPUT    flywheel.xml with a spring, and with its servo for a brake
// PROCESS  let go at 1 rad; compare the angle with the formula for a second;
//          let MuJoCo's timers count how often its first stage runs
// OUTPUT   the largest errors, the slopes, the runs in a step; for the lesson, the
//          table "errors"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_3_order

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <string>

using namespace mjcourse;
using Eigen::ArrayXd;

// With w^2 = 40 / s^2 and a brake of 2 / s, each for 0.01 kg m^2.
double exact(double t) {
  const double decay = 1, w = std::sqrt(40 - decay * decay);
  return std::exp(-decay * t) * (std::cos(w * t) + decay / w * std::sin(w * t));
}

// #region error
// The largest error of the angle in the first second, rad.
double error(const Model& model, const Data& data) {
  mj_resetData(model, data);
  data->qpos[0] = 1;
  double largest = 0;
  for (long left = std::lround(1 / model->opt.timestep); left > 0; --left) {
    mj_step(model, data);
    largest = std::max(largest, std::abs(data->qpos[0] - exact(data->time)));
  }
  return largest;
}
// #endregion

// The slope of the line that fits log(y) over log(x) best.
double slope(const ArrayXd& x, const ArrayXd& y) {
  const ArrayXd u = x.log() - x.log().mean(), w = y.log() - y.log().mean();
  return (u * w).sum() / u.square().sum();
}

int main() {
  const Model model = load_model("flywheel");
  model->jnt_stiffness[0] = 0.4;  // N m/rad
  const int servo = id_of(model, mjOBJ_ACTUATOR, "servo");
  model->actuator_gainprm[mjNGAIN * servo] = 0.02;  // N m s/rad
  model->actuator_biasprm[mjNBIAS * servo + 2] = -0.02;

  const Data data = make_data(model);
  ArrayXd step_ms(5), errors[3];
  step_ms << 2.5, 5, 10, 20, 40;
  const char* names[] = {"Euler", "RK4", "implicit"};
  std::printf(
      "step (ms)  2.5      5        10       20       40      slope  runs\n");
  for (const int integrator : {mjINT_EULER, mjINT_RK4, mjINT_IMPLICIT}) {
    const std::string name = names[integrator];
    model->opt.integrator = integrator;
    ArrayXd& found = errors[integrator] = ArrayXd(5);
    std::printf("%-8s", name.c_str());
    for (int i = 0; i < 5; ++i) {
      model->opt.timestep = step_ms[i] / 1000;
      found[i] = error(model, data);
      std::printf("  %.1e", found[i]);
    }
    const double order = slope(step_ms, found);
    const double runs = data->timer[mjTIMER_POSITION].number;
    const double per_step = runs / data->timer[mjTIMER_STEP].number;
    std::printf("  %.2f  %4.0f\n", order, per_step);
    result(name + "_slope", order);
    result(name + "_runs", per_step);
  }
  table("errors", {{"step", step_ms},
                   {"Euler", errors[mjINT_EULER]},
                   {"RK4", errors[mjINT_RK4]},
                   {"implicit", errors[mjINT_IMPLICIT]}});

  static int calls = 0;
  mjcb_control = [](const mjModel*, mjData*) { ++calls; };
  model->opt.integrator = mjINT_RK4;
  for (int step = 0; step < 500; ++step) {
    mj_step(model, data);
    mj_forward(model, data);
  }
  mjcb_control = nullptr;
  result("RK4_calls", calls);  // for a question of the lesson
}
