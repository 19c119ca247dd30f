// Lesson 1.6: how deep a ball sinks into the floor.
//
// INPUT    soft_floor.xml: balls of 0.1, 1 and 10 kg
// PROCESS  press each down with a force, wait until it rests, read how deep it
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

// The depth at which k d p = (1 - d) a: what the floor gives is what presses.
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

// How deep each of the three balls is, pressed down with `push` newton.
std::vector<double> measure(const Model& model, double push) {
  const Data data = make_data(model);
  ctrl(model, data).setConstant(push);
  for (int step = 0; step < 1000; ++step) mj_step(model, data);
  mj_forward(model, data);
  std::vector<double> depths;
  for (int i = 0; i < data->ncon; ++i) depths.push_back(-data->contact[i].dist);
  return depths;
}

int main() {
  const Model model = load_model("soft_floor");
  const int floor = id_of(model, mjOBJ_GEOM, "floor");
  const char* balls[] = {"light", "middle", "heavy"};
  std::vector<double> mass, load, measured, formula;
  double apart = 0;

  std::printf("ball    mass (kg)  push (N)  depth (mm)  formula (mm)\n");
  for (const double push : {0.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0}) {
    const std::vector<double> depths = measure(model, push);
    for (int i = 0; i < 3; ++i) {
      const double m = model->body_mass[id_of(model, mjOBJ_BODY, balls[i])];
      const double a = 9.81 + push / m;
      const double p = depth_at_rest(model, floor, a);
      if (push == 0 || push == 2)
        std::printf("%-6s  %9.1f  %8.0f  %10.3f  %12.3f\n", balls[i], m, push,
                    1000 * depths[i], 1000 * p);
      mass.push_back(m);
      load.push_back(m * a);
      measured.push_back(1000 * depths[i]);
      formula.push_back(1000 * p);
      apart = std::max(apart, std::abs(depths[i] - p));
    }
  }
  std::printf("all loads: formula within 1e-8 m: %s\n",
              apart < 1e-8 ? "yes" : "no");
  result("resting", measured[0]);  // mm, all three balls
  result("light_2N", measured[3]);
  result("heavy_2N", measured[5]);
  table("loads", {{"mass", mass},
                  {"load", load},
                  {"depth", measured},
                  {"formula", formula}});
}
