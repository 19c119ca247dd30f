// Lesson 3.4: how small should the nudge of a finite difference be?
//
// INPUT    balancing_leg.xml, leaning by 0.5 rad about y and falling at 1 rad/s
// PROCESS  nudge the lean by eps, take a step, subtract: how the next speed
//          depends on the lean, by a forward and by a centred difference
// OUTPUT   the errors against the derivative by hand; for the lesson, many
//          nudges as the table "nudges"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_4_nudge

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;
using Eigen::Vector3d;

constexpr double kLean = 0.5, kSpeed = 1;  // rad, rad/s

// #region nudge
// The speed about y after a step, if the leg leans by `nudge` more.
double next_speed(const Model& model, const Data& data, double nudge) {
  mj_resetData(model, data);
  const Vector3d lean(0, kLean, 0), more(0, nudge, 0);
  mj_integratePos(model, data->qpos, lean.data(), 1);
  mj_integratePos(model, data->qpos, more.data(), 1);
  data->qvel[1] = kSpeed;
  mj_step(model, data);
  return data->qvel[1];
}

double forward(const Model& model, const Data& data, double eps) {
  const double here = next_speed(model, data, 0);
  return (next_speed(model, data, eps) - here) / eps;
}

double centred(const Model& model, const Data& data, double eps) {
  const double before = next_speed(model, data, -eps);
  return (next_speed(model, data, eps) - before) / (2 * eps);
}
// #endregion

int main() {
  const Model model = load_model("balancing_leg");
  const Data data = make_data(model);
  const double inertia = 1.5, pull = 5 * 9.81 * 0.45;  // about the ankle
  const double h = model->opt.timestep, rate = pull / inertia;  // 1/s^2
  const double truth = h * rate * std::cos(kLean);
  const double curve = h * rate * std::sin(kLean);

  std::printf("by hand: %.12f\n", truth);
  std::printf("   eps  error, forward  error, centred\n");
  std::vector<double> nudges, ahead, around, by_hand, by_hand_centred, rounding;
  for (int i = 0; i <= 36; ++i) {
    const double eps = std::pow(10, -i / 3.0);
    const double f = std::abs(forward(model, data, eps) - truth);
    const double c = std::abs(centred(model, data, eps) - truth);
    if (i % 6 == 0 && i > 0) std::printf("%6.0e  %14.0e  %14.0e\n", eps, f, c);
    nudges.push_back(eps);
    ahead.push_back(std::max(f, 1e-16));
    around.push_back(std::max(c, 1e-16));
    by_hand.push_back(eps * curve / 2);
    by_hand_centred.push_back(eps * eps * truth / 6);
    rounding.push_back(1.1e-16 / eps);
  }
  table("nudges", {{"eps", nudges},
                   {"forward", ahead},
                   {"centred", around},
                   {"forward by hand", by_hand},
                   {"centred by hand", by_hand_centred},
                   {"rounding", rounding}});
}
