// Lesson 1.5, exercise: the cheapest setting within an error budget.
//
// INPUT    double_pendulum.xml, let go level and at rest: 0 J
// PROCESS  for each integrator, try steps from coarse to fine until the total
//          energy stays within 10 mJ for two seconds
// OUTPUT   the first step that passes, and how often it computes accelerations
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_5_budget

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

constexpr double kDuration = 2, kBudget = 0.01;  // s, J

double energy_error(const Model& model, double timestep) {
  model->opt.timestep = timestep;
  const Data data = make_data(model);
  const long steps = std::lround(kDuration / timestep);
  double error = 0;
  for (long step = 0; step < steps; ++step) {
    mj_step(model, data);
    mj_forward(model, data);
    error = std::max(error, std::abs(data->energy[0] + data->energy[1]));
  }
  return error;
}

int main() {
  const Model model = load_model("double_pendulum");
  struct {
    const char* name;
    int integrator, evaluations;  // of the acceleration, in a step
  } const candidates[] = {{"Euler", mjINT_EULER, 1}, {"RK4", mjINT_RK4, 4}};

  double cost[2];
  for (int i = 0; i < 2; ++i) {
    const auto& [name, integrator, evaluations] = candidates[i];
    model->opt.integrator = integrator;
    for (const double ms :
         {40.0, 25.0, 20.0, 10.0, 5.0, 2.0, 1.0, 0.5, 0.25, 0.2, 0.1, 0.05}) {
      const double error = energy_error(model, ms / 1000);
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
}
