// Lesson 2.1: one motor, many gears.
//
// INPUT    geared_links.xml, its middle link alone, without gravity
// PROCESS  give the joint a gear n and the armature n^2 J, and its motor a
//          torque of 0.3 N m for 50 ms; measure the acceleration; the same with
//          an armature of 0; then seek the best gear, without and with a load
// OUTPUT   the accelerations; the best gears, measured and by formula; for the
//          lesson, the table "gears"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_1_gear

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;

constexpr double kInertia = 0.01, kRotor = 1e-4;  // kg m^2
constexpr double kTorque = 0.3;                   // N m, of the rotor

// #region measure
// The link's mean acceleration in its first 50 ms, with a gear of n and
// against a load in N m.
double measure(const Model& model, double n, double armature, double load) {
  const int ten = id_of(model, mjOBJ_JOINT, "ten");
  model->actuator_gear[6 * ten] = n;
  model->dof_armature[ten] = armature;
  const Data data = make_data(model);
  data->ctrl[ten] = kTorque;
  data->qfrc_applied[ten] = -load;
  for (int step = 0; step < 25; ++step) mj_step(model, data);
  return data->qvel[ten] / data->time;
}
// #endregion

double best_gear(const Model& model, double load) {
  double best = 1, most = -1e9;
  for (double gear = 1; gear < 100; gear += 0.01) {
    const double here = measure(model, gear, gear * gear * kRotor, load);
    if (here > most) most = here, best = gear;
  }
  return best;
}

int main() {
  const Model model = load_model("geared_links");
  model->opt.gravity[2] = 0;
  std::printf("gear  torque (N m)  inertia (kg m^2)  rad/s^2  no armature\n");
  for (const double n : {1, 10, 100}) {
    const double with = measure(model, n, n * n * kRotor, 0);
    const double without = measure(model, n, 0, 0);
    std::printf("%4.0f  %12.1f  %16.4f  %7.2f  %11.0f\n", n, n * kTorque,
                kInertia + n * n * kRotor, with, without);
    result("with_" + std::to_string(std::lround(n)), with);
    result("too_fast_" + std::to_string(std::lround(n)), without / with);
  }
  const double load = 0.6, ratio = load / kTorque;
  const double matched = std::sqrt(kInertia / kRotor);
  const double loaded = ratio + std::sqrt(ratio * ratio + kInertia / kRotor);
  const double free_best = best_gear(model, 0);
  const double load_best = best_gear(model, load);
  std::printf("best gear               measured  formula\n");
  std::printf("without a load             %5.2f    %5.2f\n", free_best,
              matched);
  std::printf("against 0.6 N m            %5.2f    %5.2f\n", load_best, loaded);
  result("best", free_best);
  result("best_loaded", load_best);

  std::vector<double> gears, with, without, formula;
  for (int i = 0; i <= 40; ++i) {
    const double n = std::pow(10, i / 16.0);  // 1 to 316
    gears.push_back(n);
    with.push_back(measure(model, n, n * n * kRotor, 0));
    without.push_back(measure(model, n, 0, 0));
    formula.push_back(n * kTorque / (kInertia + n * n * kRotor));
  }
  table("gears", {{"gear", gears},
                  {"measured", with},
                  {"forgotten", without},
                  {"formula", formula}});
}
