// Lesson 1.4, challenge: a wanted motion, and the controls that make it.
//
// INPUT    three_arms.xml; a wanted swing of the front arm, for two seconds
// PROCESS  put the wanted pose, velocity and acceleration into a second mjData,
//          ask mj_inverse for the torques, divide by the gears: that is ctrl;
//          apply it with steps of 2 and of 1 ms, then with weak springs and
//          dampers towards the wanted motion
// OUTPUT   the largest error of an angle in each half second
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_4_follow

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;
using Eigen::Array2d, Eigen::Vector2d;

// The front arm's joints are the last two: tail<2>().
struct Wanted {
  Vector2d q, v, a;
};
Wanted wanted(double t) {
  const Array2d middle(0.5, -1), swing(0.4, 0.6), rate(2, 3);  // rad, rad, 1/s
  return {middle + swing * (1 - (rate * t).cos()),
          swing * rate * (rate * t).sin(),
          swing * rate.square() * (rate * t).cos()};
}

// The torques of the wanted motion, by inverse dynamics.
Vector2d torques(const Model& model, const Data& ideal, const Wanted& want) {
  qpos(model, ideal).tail<2>() = want.q;
  qvel(model, ideal).tail<2>() = want.v;
  qacc(model, ideal).tail<2>() = want.a;
  mj_inverse(model, ideal);
  return VectorView(ideal->qfrc_inverse, model->nv).tail<2>();
}

// The largest error of an angle in each half second.
std::vector<double> errors(const Model& model, double timestep, double spring) {
  model->opt.timestep = timestep;
  const Data data = make_data(model), ideal = make_data(model);
  const int half_second = std::lround(0.5 / timestep);
  std::vector<double> largest(4, 0);
  for (int step = 0; step < 4 * half_second; ++step) {
    const Wanted want = wanted(step * timestep);
    const Vector2d off = want.q - qpos(model, data).tail<2>();
    const Vector2d slow = want.v - qvel(model, data).tail<2>();
    const Vector2d torque =
        torques(model, ideal, want) + spring * (off + 0.1 * slow);
    for (const int motor : {0, 1})
      data->ctrl[motor] = torque[motor] / model->actuator_gear[6 * motor];
    mj_step(model, data);
    double& so_far = largest[step / half_second];
    so_far = std::max(so_far, off.cwiseAbs().maxCoeff());
  }
  return largest;
}

void report(const char* name, const std::vector<double>& largest) {
  std::printf("%-25s", name);
  for (const double error : largest) std::printf("  %7.5f", error);
  std::puts("");
}

int main() {
  const Model model = load_model("three_arms");
  std::puts("largest error (rad) in     0-0.5 s  0.5-1 s  1-1.5 s  1.5-2 s");
  const std::vector<double> alone = errors(model, 0.002, 0);
  report("mj_inverse, 2 ms", alone);
  report("mj_inverse, 1 ms", errors(model, 0.001, 0));
  const std::vector<double> held = errors(model, 0.002, 10);
  report("and springs, 2 ms", held);
  result("growth", alone[1] / alone[0]);
  result("bought_ms", 500 * std::log(2) / std::log(alone[1] / alone[0]));
  result("held_mrad", 1000 * *std::max_element(held.begin(), held.end()));
}
