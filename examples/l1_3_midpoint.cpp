// Lesson 1.3, exercise: a step of your own, by the midpoint rule.
//
// INPUT    flywheel.xml with a spring and damping; joint_zoo.xml's free box
// PROCESS  look half a step ahead, compute the acceleration there, and take the
//          whole step with that; compare the wheel's angle with the formula for
//          a second; throw the box
// OUTPUT   the errors and their slope, which is the order; checks the order,
//          and where the box is after half a second
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

// Moves data->qpos and data->qvel on by one time step, for any model.
void midpoint_step(const Model& model, const Data& data) {
  const double h = model->opt.timestep;
  const VectorXd q = qpos(model, data), v = qvel(model, data);
  // #region answer
  mj_forward(model, data);  // the whole pipeline, and nothing moves
  const VectorXd half_v = v + h / 2 * qacc(model, data);
  mj_integratePos(model, data->qpos, v.data(), h / 2);
  qvel(model, data) = half_v;

  mj_forward(model, data);  // and once more, in the middle
  const VectorXd new_v = v + h * qacc(model, data);
  qpos(model, data) = q;
  mj_integratePos(model, data->qpos, half_v.data(), h);
  qvel(model, data) = new_v;
  // #starter
  // // This is Euler's rule, of first order: make the midpoint rule of it.
  // mj_forward(model, data);  // qacc, here and now
  // mj_integratePos(model, data->qpos, v.data(), h);
  // qvel(model, data) = v + h * qacc(model, data);
  // #wrong starts-in-the-middle: half the step leaves a quarter
  // mj_forward(model, data);
  // mj_integratePos(model, data->qpos, v.data(), h / 2);
  // const VectorXd half_v = qvel(model, data) = v + h / 2 * qacc(model, data);
  // mj_forward(model, data);
  // mj_integratePos(model, data->qpos, half_v.data(), h);
  // qvel(model, data) = v + h * qacc(model, data);
  // #wrong adds-velocities: a thrown box falls and turns
  // mj_forward(model, data);
  // const VectorXd half_v = v + h / 2 * qacc(model, data);
  // qpos(model, data).head(model->nv) += h / 2 * v;
  // qvel(model, data) = half_v;
  // mj_forward(model, data);
  // qpos(model, data) = q;
  // qpos(model, data).head(model->nv) += h * half_v;
  // qvel(model, data) = v + h * qacc(model, data);
  // #endregion
  data->time += h;
}

// The box turns about its third axis, at 3 rad/s: it does not tumble.
void check_box() {
  const Model model = load_model("joint_zoo");
  const Data data = make_data(model);
  data->qpos[2] = 10;  // m
  data->qvel[0] = 2, data->qvel[5] = 3;
  const double t = 0.5, g = model->opt.gravity[2] = -9.81;
  VectorXd expected(7);
  expected << data->qpos[0] + 2 * t, 0, 10 + g * t * t / 2, std::cos(3 * t / 2),
      0, 0, std::sin(3 * t / 2);
  for (int i = 0; i < 250; ++i) midpoint_step(model, data);
  expect_near(qpos(model, data).head(7), expected, 1e-6,
              "a thrown box falls and turns as it should",
              "qpos has more numbers than qvel: a quaternion is no sum of "
              "velocities");
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
  if (expect_near(order, 2, 0.1, "half the step leaves a quarter of the error",
                  "the whole step needs the speed and the acceleration of the "
                  "midpoint, and must begin where the step begins"))
    check_box();
}
