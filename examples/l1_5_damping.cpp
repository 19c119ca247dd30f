// Lesson 1.5: damping hides the error. A ledger finds it.
//
// INPUT    double_pendulum.xml, with friction in both of its joints
// PROCESS  simulate ten seconds with a coarse step and Euler, then with a fine
//          one and RK4; beside each, integrate the power v'Bv that damping takes
// OUTPUT   what is left, what damping took, and what neither explains; for the
//          lesson, the coarse run as the table "ledger"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_5_damping

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;

struct Ledger {
  std::vector<double> time, energy, sum;
};

// #region ledger
// Energy, and energy plus what damping took. Only the sum must stay at 0.
Ledger keep_ledger(const Model& model, int integrator, double timestep) {
  model->opt.integrator = integrator;
  model->opt.timestep = timestep;
  const Data data = make_data(model);
  const Eigen::Map<const Eigen::ArrayXd> damping(model->dof_damping, model->nv);

  Ledger ledger;
  double taken = 0, last_power = 0;
  const long steps = std::lround(10 / timestep), every = steps / 250;
  for (long step = 0; step <= steps; ++step) {
    if (step > 0) mj_step(model, data);
    mj_forward(model, data);
    const double power = (damping * qvel(model, data).array().square()).sum();
    if (step > 0) taken += timestep * (last_power + power) / 2;  // trapezoid
    last_power = power;
    if (step % every > 0) continue;
    const double energy = data->energy[0] + data->energy[1];
    ledger.time.push_back(data->time);
    ledger.energy.push_back(energy);
    ledger.sum.push_back(energy + taken);
  }
  return ledger;
}
// #endregion

void report(const char* label, const Ledger& ledger) {
  const double energy = ledger.energy.back(), sum = ledger.sum.back();
  std::printf("%-12s %10.3f %12.3f %16s\n", label, energy, sum - energy,
              to_text(sum, 3).c_str());
}

int main() {
  const Model model = load_model("double_pendulum");
  for (int dof = 0; dof < model->nv; ++dof)
    model->dof_damping[dof] = 0.02;  // N m s/rad

  const Ledger coarse = keep_ledger(model, mjINT_EULER, 0.02);
  const Ledger fine = keep_ledger(model, mjINT_RK4, 0.001);
  std::printf("after 10 s   energy (J)  damping (J)  unexplained (J)\n");
  report("Euler, 20 ms", coarse);
  report("RK4, 1 ms", fine);

  result("fallen", -coarse.energy.back());
  result("created", coarse.sum.back());
  result("fallen_fine", -fine.energy.back());
  const double taken_fine = fine.sum.back() - fine.energy.back();
  const double taken = coarse.sum.back() - coarse.energy.back();
  result("taken", taken);
  result("too_much", taken - taken_fine);
  result("too_much_percent", 100 * (taken / taken_fine - 1));
  table("ledger", {{"time", coarse.time},
                   {"energy", coarse.energy},
                   {"energy + damping", coarse.sum}});
}
