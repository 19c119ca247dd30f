// Lesson 3.1: how much damping a servo needs.
//
// INPUT    servo_arm.xml without gravity; its servo of 50 N m/rad
// PROCESS  ask for 0.5 rad, with one damping ratio after another; measure how
//          far the arm overshoots, and when it stays within 1 %; then give it
//          a load, and keep the damping
// OUTPUT   overshoot and time; for the lesson, the table "steps"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_1_damping

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <string>
#include <vector>

using namespace mjcourse;

constexpr double kTarget = 0.5;  // rad

// #region ratio
// M_ii, with the armature: the inertia that the servo has to move.
double inertia_of(const Model& model, int dof) {
  const Data data = make_data(model);
  mj_forward(model, data);
  Eigen::MatrixXd inertia(model->nv, model->nv);
  mj_fullM(model, inertia.data(), data->qM);
  return inertia(dof, dof);
}

double critical_damping(double kp, double inertia) {
  return 2 * std::sqrt(kp * inertia);
}
// #endregion

struct Step {
  double overshoot = 0;  // a share of the step
  double settled = 0;    // s, after which the error stays below 1 %
  std::vector<double> time, angle;
};
Step respond(const Model& model, double seconds) {
  const Data data = make_data(model);
  data->ctrl[0] = kTarget;
  Step step;
  for (int i = 0; data->time < seconds; ++i) {
    if (i % 40 == 0) {
      step.time.push_back(data->time);
      step.angle.push_back(data->qpos[0]);
    }
    mj_step(model, data);
    const double reached = data->qpos[0] / kTarget;
    step.overshoot = std::max(step.overshoot, reached - 1);
    if (std::abs(reached - 1) > 0.01) step.settled = data->time;
  }
  return step;
}

double formula(double ratio) {
  if (ratio >= 1) return 0;
  return std::exp(-M_PI * ratio / std::sqrt(1 - ratio * ratio));
}

int main() {
  const Model model = load_model("servo_arm");
  model->opt.gravity[2] = 0;
  model->opt.timestep = 0.0002;  // short, since the formulas know no steps
  const double kp = model->actuator_gainprm[0];
  const double critical = critical_damping(kp, inertia_of(model, 0));
  result("inertia", inertia_of(model, 0));
  result("critical", critical);

  std::printf("ratio  damping  overshoot  formula  within 1 %% after\n");
  std::vector<double> time, angle, which;
  for (const double ratio : {0.2, 0.5, 0.8, 1.0, 3.0}) {
    model->dof_damping[0] = ratio * critical;
    const Step step = respond(model, 2);
    std::printf("%5.1f  %7.2f  %7.1f %%  %5.1f %%  %12.2f s\n", ratio,
                ratio * critical, 100 * step.overshoot, 100 * formula(ratio),
                step.settled);
    result("settled_" + std::to_string(std::lround(10 * ratio)), step.settled);
    if (ratio == 0.5 || ratio == 0.8) continue;
    for (std::size_t i = 0; step.time[i] < 1.2; ++i) {
      time.push_back(step.time[i]);
      angle.push_back(step.angle[i]);
      which.push_back(ratio);
    }
  }
  table("steps", {{"time", time}, {"angle", angle}, {"ratio", which}});

  model->dof_damping[0] = critical;
  model->body_mass[id_of(model, mjOBJ_BODY, "load")] = 1;  // kg
  const double loaded = critical / critical_damping(kp, inertia_of(model, 0));
  std::printf("with a load of 1 kg: ratio %.2f, overshoot %.1f %%\n", loaded,
              100 * respond(model, 0.5).overshoot);
  result("loaded_ratio", loaded);
}
