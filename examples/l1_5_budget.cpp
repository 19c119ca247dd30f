// Lesson 1.5, exercise: the cheapest setting within an error budget.
//
// INPUT    double_pendulum.xml, let go level and at rest: 0 J; a mass that
//          falls or swings on a spring
// PROCESS  for each integrator, try steps from coarse to fine until the total
//          energy stays within 10 mJ for two seconds
// OUTPUT   the first step that passes, and how often it computes accelerations;
//          checks the error against formulas for the mass
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_5_budget

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

constexpr double kDuration = 2, kBudget = 0.01;  // s, J

// By how much the total energy (J) is wrong at most, in the kDuration seconds
// that follow on the state in `data`: at the end of any step, against the
// energy at the beginning. Nothing drives or damps the model, and it has the
// flag for the energy.
double energy_error(const Model& model, const Data& data) {
  const long steps = std::lround(kDuration / model->opt.timestep);
  double error = 0;
  // #region answer
  mj_forward(model, data);
  const double start = data->energy[0] + data->energy[1];
  for (long step = 0; step < steps; ++step) {
    mj_step(model, data);
    mj_forward(model, data);  // the energy of now
    const double energy = data->energy[0] + data->energy[1];
    error = std::max(error, std::abs(energy - start));
  }
  // #starter
  // for (long step = 0; step < steps; ++step) mj_step(model, data);
  // // How far does data->energy get from where it was?
  // #wrong reads-the-last-instant: a falling mass
  // mj_forward(model, data);
  // const double start = data->energy[0] + data->energy[1];
  // for (long step = 0; step < steps; ++step) {
  //   mj_step(model, data);
  //   const double energy = data->energy[0] + data->energy[1];
  //   error = std::max(error, std::abs(energy - start));
  // }
  // #wrong forgets-that-it-moves: it does not matter how high
  // mj_forward(model, data);
  // const double start = data->energy[0];
  // for (long step = 0; step < steps; ++step) {
  //   mj_step(model, data);
  //   mj_forward(model, data);
  //   const double energy = data->energy[0] + data->energy[1];
  //   error = std::max(error, std::abs(energy - start));
  // }
  // #wrong starts-at-zero: it does not matter how high
  // for (long step = 0; step < steps; ++step) {
  //   mj_step(model, data);
  //   mj_forward(model, data);
  //   const double energy = data->energy[0] + data->energy[1];
  //   error = std::max(error, std::abs(energy));
  // }
  // #wrong looks-at-the-end-only: a swinging mass
  // mj_forward(model, data);
  // const double start = data->energy[0] + data->energy[1];
  // for (long step = 0; step < steps; ++step) mj_step(model, data);
  // mj_forward(model, data);
  // error = std::abs(data->energy[0] + data->energy[1] - start);
  // #endregion
  return error;
}

// A mass of 1 kg on a vertical slide, with Euler and steps of h.
double mass_error(double stiffness, double g, double start, double speed,
                  double h) {
  const Model model = load_model_xml(
      "<mujoco><option><flag energy='enable'/></option><worldbody><body>"
      "<joint type='slide'/><geom size='0.1' mass='1'/>"
      "</body></worldbody></mujoco>");
  model->jnt_stiffness[0] = stiffness;
  model->opt.gravity[2] = -g;
  model->opt.timestep = h;
  const Data data = make_data(model);
  data->qpos[0] = start;
  data->qvel[0] = speed;
  return energy_error(model, data);
}

void check() {
  const double g = 9.81, t = kDuration, h = 0.01;
  // It is g h t / 2 below the parabola (lesson 0.1), at the right speed.
  const double fallen = g * g * h * t / 2;
  const bool falls = expect_near(
      mass_error(0, g, 0, 0, h), fallen, 1e-9,
      "a falling mass has lost m g^2 h t / 2 at the end",
      "after mj_step, the energy in data is that of the instant before; and "
      "a loss is an error, too");
  if (falls &&
      expect_near(mass_error(0, g, 30, 5, h), fallen, 1e-9,
                  "it does not matter how high it starts, and how fast",
                  "an error is a difference from all the energy at the start, "
                  "once that is known"))
    // Euler keeps the energy less h k q v / 2, and q v is A^2 w / 2 at most.
    expect_near(mass_error(100, 0, 0.1, 0, 0.001), 0.001 * 100 * 0.01 * 10 / 4,
                2e-5, "a swinging mass is wrong by h k w A^2 / 4 at most",
                "the largest error need not be the last one");
}

int main() {
  const Model model = load_model("double_pendulum");
  struct {
    const char* name;
    int integrator, evaluations;  // of the acceleration, in a step
  } const candidates[] = {{"Euler", mjINT_EULER, 1}, {"RK4", mjINT_RK4, 4}};

  double cost[2] = {};
  for (int i = 0; i < 2; ++i) {
    const auto& [name, integrator, evaluations] = candidates[i];
    model->opt.integrator = integrator;
    for (const double ms :
         {40.0, 25.0, 20.0, 10.0, 5.0, 2.0, 1.0, 0.5, 0.25, 0.2, 0.1, 0.05}) {
      model->opt.timestep = ms / 1000;
      const double error = energy_error(model, make_data(model));
      if (!(error < kBudget)) continue;
      cost[i] = evaluations * kDuration / ms * 1000;
      std::printf("%-5s  %5.2f ms  %5.2f mJ  %5.0f accelerations\n", name, ms,
                  1000 * error, cost[i]);
      break;
    }
  }
  result("euler_cost", cost[0]);
  result("rk4_cost", cost[1]);
  result("ratio", cost[0] / cost[1]);
  check();
}
