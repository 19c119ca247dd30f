// Lesson 1.3, exercise: a step of your own, by the midpoint rule.
//
// INPUT    flywheel.xml with a spring and damping
// PROCESS  look half a step ahead, compute the acceleration there, and take the
//          whole step with that; compare the angle with the formula for a
//          second
// OUTPUT   the errors and their slope, which is the order
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_3_midpoint

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;
using Eigen::ArrayXd, Eigen::VectorXd;

// With w^2 = 40 / s^2 and damping of 2 / s, each for 0.01 kg m^2.
double exact(double t) {
  const double decay = 1, w = std::sqrt(40 - decay * decay);
  return std::exp(-decay * t) * (std::cos(w * t) + decay / w * std::sin(w * t));
}

void midpoint_step(const Model& model, const Data& data) {
  const double h = model->opt.timestep;
  const VectorXd q = qpos(model, data), v = qvel(model, data);

  mj_forward(model, data);  // the whole pipeline, and nothing moves
  const VectorXd half_v = v + h / 2 * qacc(model, data);
  mj_integratePos(model, data->qpos, v.data(), h / 2);
  qvel(model, data) = half_v;

  mj_forward(model, data);  // and once more, in the middle
  const VectorXd new_v = v + h * qacc(model, data);
  qpos(model, data) = q;
  mj_integratePos(model, data->qpos, half_v.data(), h);
  qvel(model, data) = new_v;
  data->time += h;
}

int main() {
  const Model model = load_model("flywheel");
  model->jnt_stiffness[0] = 0.4;  // N m/rad
  model->dof_damping[0] = 0.02;   // N m s/rad

  ArrayXd step_ms(5), error = ArrayXd::Zero(5);
  step_ms << 2.5, 5, 10, 20, 40;
  for (int i = 0; i < 5; ++i) {
    model->opt.timestep = step_ms[i] / 1000;
    const Data data = make_data(model);
    data->qpos[0] = 1;
    for (long left = std::lround(1000 / step_ms[i]); left > 0; --left) {
      midpoint_step(model, data);
      const double off = std::abs(data->qpos[0] - exact(data->time));
      error[i] = std::max(error[i], off);
    }
    std::printf("%4.1f ms  %.1e rad\n", step_ms[i], error[i]);
  }
  const ArrayXd x = step_ms.log() - step_ms.log().mean();
  const double order = (x * error.log()).sum() / x.square().sum();
  std::printf("slope    %.2f\n", order);
  result("slope", order);
}
