// Lesson 1.5: how the energy error falls with the step.
//
// INPUT    double_pendulum.xml, let go level and at rest: 0 J
// PROCESS  simulate one second with five steps and two integrators; note the
//          largest |total energy|; fit the slope of log(error) over log(step)
// OUTPUT   the errors, the two slopes; for the lesson, the table "study"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_5_step_size

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;
using Eigen::ArrayXd;

// The largest error of the total energy in the first second, J.
double energy_error(const Model& model, int integrator, double timestep) {
  model->opt.integrator = integrator;
  model->opt.timestep = timestep;
  const Data data = make_data(model);
  const long steps = std::lround(1 / timestep);
  double error = 0;
  for (long step = 0; step < steps; ++step) {
    mj_step(model, data);
    mj_forward(model, data);
    error = std::max(error, std::abs(data->energy[0] + data->energy[1]));
  }
  return error;
}

// The slope of the line that fits log(y) over log(x) best.
double slope(const ArrayXd& x, const ArrayXd& y) {
  const ArrayXd u = x.log() - x.log().mean(), w = y.log() - y.log().mean();
  return (u * w).sum() / u.square().sum();
}

int main() {
  const Model model = load_model("double_pendulum");
  ArrayXd step_ms(5), euler(5), rk4(5);
  step_ms << 0.25, 0.5, 1, 2, 4;

  std::printf("step (ms)   Euler (J)   RK4 (J)\n");
  for (int i = 0; i < step_ms.size(); ++i) {
    euler[i] = energy_error(model, mjINT_EULER, step_ms[i] / 1000);
    rk4[i] = energy_error(model, mjINT_RK4, step_ms[i] / 1000);
    std::printf("%6.2f      %.2e    %.1e\n", step_ms[i], euler[i], rk4[i]);
  }
  const double euler_slope = slope(step_ms, euler),
               rk4_slope = slope(step_ms, rk4);
  std::printf("slope       %.2f        %.2f\n", euler_slope, rk4_slope);

  result("euler_slope", euler_slope);
  result("rk4_slope", rk4_slope);
  result("euler_2ms_mJ", 1000 * euler[3]);
  result("rk4_halving", rk4[3] / rk4[2]);  // from 2 ms to 1 ms
  table("study", {{"step", step_ms}, {"Euler", euler}, {"RK4", rk4}});
}
