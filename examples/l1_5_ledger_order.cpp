// Lesson 1.5, challenge: when the ledger is worse than the simulation.
//
// INPUT    double_pendulum.xml, with friction in both of its joints
// PROCESS  simulate one second with RK4 and four steps; integrate the power of
//          damping by the trapezoidal rule and by Simpson's; fit the slopes
// OUTPUT   what energy and damping leave unexplained, by either rule
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_5_ledger_order

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;
using Eigen::Array2d, Eigen::ArrayXd;

// The unexplained energy after one second, J: by the trapezoidal rule, and by
// Simpson's, which weighs the steps 1 4 2 4 ... 2 4 1.
Array2d unexplained(const Model& model, double timestep) {
  model->opt.timestep = timestep;
  const Data data = make_data(model);
  const Eigen::Map<const ArrayXd> damping(model->dof_damping, model->nv);

  const long steps = std::lround(1 / timestep);  // even
  Array2d taken(0, 0);
  for (long step = 0; step <= steps; ++step) {
    if (step > 0) mj_step(model, data);
    mj_forward(model, data);
    const double power = (damping * qvel(model, data).array().square()).sum();
    const bool inner = step > 0 && step < steps;
    taken[0] += power * timestep * (inner ? 1 : 0.5);
    taken[1] += power * timestep / 3 * (!inner ? 1 : step % 2 == 1 ? 4 : 2);
  }
  return (data->energy[0] + data->energy[1] + taken).abs();
}

double slope(const ArrayXd& x, const ArrayXd& y) {
  const ArrayXd u = x.log() - x.log().mean(), w = y.log() - y.log().mean();
  return (u * w).sum() / u.square().sum();
}

int main() {
  const Model model = load_model("double_pendulum");
  model->opt.integrator = mjINT_RK4;
  for (int dof = 0; dof < model->nv; ++dof)
    model->dof_damping[dof] = 0.02;  // N m s/rad

  ArrayXd step_ms(4), trapezoid(4), simpson(4);
  step_ms << 0.5, 1, 2.5, 5;
  std::printf("step (ms)  trapezoid (J)  Simpson (J)\n");
  for (int i = 0; i < step_ms.size(); ++i) {
    const Array2d error = unexplained(model, step_ms[i] / 1000);
    trapezoid[i] = error[0];
    simpson[i] = error[1];
    std::printf("%6.1f      %.1e        %.0e\n", step_ms[i], error[0],
                error[1]);
  }
  const double order[] = {slope(step_ms, trapezoid), slope(step_ms, simpson)};
  std::printf("slope       %.2f           %.2f\n", order[0], order[1]);
  result("trapezoid_slope", order[0]);
  result("simpson_slope", order[1]);
}
