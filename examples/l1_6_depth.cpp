// Lesson 1.6: how deep a ball sinks into the floor.
//
// INPUT    soft_floor.xml: balls of 0.1, 1 and 10 kg
// PROCESS  press one down with a force, wait until it rests, read how deep it
//          is; solve the documented formulas for the same depth
// OUTPUT   both depths; for the lesson, many loads as the table "loads"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_6_depth

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;

// #region formula
// The impedance d at a depth: solimp is dmin, dmax, width, midpoint, power.
double impedance(const mjtNum* solimp, double depth) {
  const double dmin = solimp[0], dmax = solimp[1];
  const double mid = solimp[3], power = solimp[4];
  const double x = std::min(depth / solimp[2], 1.0);
  const double y = x <= mid
                       ? mid * std::pow(x / mid, power)
                       : 1 - (1 - mid) * std::pow((1 - x) / (1 - mid), power);
  return dmin + y * (dmax - dmin);
}

// The depth at which k d p = (1 - d) a, where the contact balances the load.
double depth_at_rest(const mjModel* model, int geom, double acceleration) {
  const mjtNum* solref = model->geom_solref + mjNREF * geom;
  const mjtNum* solimp = model->geom_solimp + mjNIMP * geom;
  double low = 0, high = 1;  // m; the left side grows with the depth
  while (high - low > 1e-12) {
    const double p = (low + high) / 2, d = impedance(solimp, p);
    const double k = d / std::pow(solimp[1] * solref[0] * solref[1], 2);
    (k * d * p < (1 - d) * acceleration ? low : high) = p;
  }
  return low;
}
// #endregion

// How deep a ball is after two seconds, pressed down with `push` newton.
double measure(const Model& model, int ball, double push) {
  const Data data = make_data(model);
  ctrl(model, data)[ball] = push;
  for (int step = 0; step < 1000; ++step) mj_step(model, data);
  mj_forward(model, data);
  return -data->contact[ball].dist;  // the floor touches one after the other
}

int main() {
  const Model model = load_model("soft_floor");
  const int floor = id_of(model, mjOBJ_GEOM, "floor");
  const auto weight = [&](int ball) {
    return 9.81 * model->body_mass[ball + 1];  // body 0 is the world
  };
  const auto formula = [&](int ball, double push) {
    const double load = weight(ball) + push;
    return depth_at_rest(model, floor, load / model->body_mass[ball + 1]);
  };

  std::printf("mass (kg)  push (N)  depth (mm)  formula (mm)\n");
  for (const double push : {0.0, 2.0})
    for (int ball = 0; ball < 3; ++ball)
      std::printf("%9.1f  %8.0f  %10.3f  %12.3f\n", model->body_mass[ball + 1],
                  push, 1000 * measure(model, ball, push),
                  1000 * formula(ball, push));

  std::vector<double> mass, load, measured, predicted;
  double apart = 0;
  for (int ball = 0; ball < 3; ++ball) {
    for (double times = 1; times < 130; times *= std::sqrt(2)) {
      const double push = (times - 1) * weight(ball);
      mass.push_back(model->body_mass[ball + 1]);
      load.push_back(weight(ball) + push);
      measured.push_back(1000 * measure(model, ball, push));
      predicted.push_back(1000 * formula(ball, push));
      apart = std::max(apart, std::abs(measured.back() - predicted.back()));
    }
  }
  std::printf("up to 128 times the weight: within 1e-5 mm: %s\n",
              apart < 1e-5 ? "yes" : "no");
  table("loads", {{"mass", mass},
                  {"load", load},
                  {"depth", measured},
                  {"formula", predicted}});
}
