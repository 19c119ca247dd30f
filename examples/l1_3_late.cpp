// Lesson 1.3: the same brake, by the results of a step: qvel is up to date, a
// sensor is one step old.
//
// INPUT    flywheel.xml, 0.01 kg m^2, a step of 10 ms
// PROCESS  brake against a speed: by the reading of the sensor that the last
//          mj_step left, by the qvel that it left, and by the reading of
//          mj_step1. A step is linear, so it is a matrix; the
//          error grows by its largest eigenvalue
// OUTPUT   the largest gain at which the wheel stays calm; for the lesson, the
//          table "growth"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_3_late

#include <algorithm>
#include <complex>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;
using Eigen::Matrix2d, Eigen::Vector2d;

// #region brakes
// Each takes (speed, last reading) one step on.
Vector2d late(const Model& model, const Data& data, double gain, Vector2d was) {
  data->qvel[0] = was[0];
  data->ctrl[0] = -gain * was[1];  // what mj_step left in sensordata
  mj_step(model, data);
  return {data->qvel[0], data->sensordata[0]};
}

Vector2d state(const Model& model, const Data& data, double gain,
               Vector2d was) {
  data->qvel[0] = was[0];
  data->ctrl[0] = -gain * data->qvel[0];  // what mj_step left in qvel
  mj_step(model, data);
  return {data->qvel[0], data->sensordata[0]};
}

Vector2d middle(const Model& model, const Data& data, double gain,
                Vector2d was) {
  data->qvel[0] = was[0];
  mj_step1(model, data);
  data->ctrl[0] = -gain * data->sensordata[0];  // what it says now
  mj_step2(model, data);
  return {data->qvel[0], data->sensordata[0]};
}
// #endregion

using Brake = Vector2d (*)(const Model&, const Data&, double, Vector2d);

// #region growth
double growth(const Model& model, Brake brake, double gain) {
  const Data data = make_data(model);
  Matrix2d step;
  step << brake(model, data, gain, {1, 0}), brake(model, data, gain, {0, 1});
  // Its eigenvalues solve x^2 - trace x + determinant = 0.
  const double half = step.trace() / 2;
  const std::complex<double> square = half * half - step.determinant();
  const std::complex<double> root = std::sqrt(square);
  return std::max(std::abs(half + root), std::abs(half - root));
}
// #endregion

double largest_calm_gain(const Model& model, Brake brake) {
  double calm = 0.1, wild = 10;
  while (wild - calm > 1e-9) {
    const double gain = (calm + wild) / 2;
    (growth(model, brake, gain) > 1 ? wild : calm) = gain;
  }
  return calm;
}

int main() {
  const Model model = load_model("flywheel");
  const double late_limit = largest_calm_gain(model, late);
  const double state_limit = largest_calm_gain(model, state);
  const double middle_limit = largest_calm_gain(model, middle);
  std::printf("largest calm gain (N m s/rad)\n");
  std::printf("  sensordata, after mj_step:  %.3f\n", late_limit);
  std::printf("  qvel, after mj_step:        %.3f\n", state_limit);
  std::printf("  sensordata, after mj_step1: %.3f\n", middle_limit);

  std::vector<double> gains, after, between;
  for (int i = 0; i <= 50; ++i) {
    gains.push_back(0.05 * i);
    after.push_back(growth(model, late, gains.back()));
    between.push_back(growth(model, middle, gains.back()));
  }
  result("late_limit", late_limit);
  result("middle_limit", middle_limit);
  const Data data = make_data(model);
  Vector2d wheel(5, 5);  // rad/s
  for (int step = 0; step < 10; ++step) wheel = late(model, data, 1.5, wheel);
  result("faster", wheel[0] / 5);
  table("growth", {{"gain", gains}, {"late", after}, {"middle", between}});
}
