// Lesson 1.5, challenge: when the ledger is worse than the simulation.
//
// INPUT    double_pendulum.xml, with friction in both of its joints
// PROCESS  simulate one second with RK4 and four steps; integrate the power of
//          damping by the trapezoidal rule and by Simpson's; fit the slopes
// OUTPUT   what energy and damping leave unexplained, by either rule; checks
//          the better rule's slope, and what it makes of a constant power
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_5_ledger_order

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;
using Eigen::Array2d, Eigen::ArrayXd;

// Energy (J) from the power (W) at the ends of all steps, of length h.
double trapezoid(const ArrayXd& power, double h) {
  return h * (power.sum() - (power[0] + power[power.size() - 1]) / 2);
}

// The same by a rule of fourth order. The number of steps is even and positive,
// so the number of powers, power.size(), is odd and at least 3.
double better(const ArrayXd& power, double h) {
  // #region answer
  const long steps = power.size() - 1;
  double energy = 0;
  for (long i = 0; i <= steps; ++i) {
    const bool is_end = i == 0 || i == steps;  // weights 1 4 2 4 ... 2 4 1
    energy += h / 3 * power[i] * (is_end ? 1 : i % 2 == 1 ? 4 : 2);
  }
  return energy;
  // #starter
  // return trapezoid(power, h);  // its slope is 2
  // #wrong weighs-ends-like-inner-ones: a constant power
  // double energy = 0;
  // for (long i = 0; i < power.size(); ++i)
  //   energy += h / 3 * power[i] * (i % 2 == 1 ? 4 : 2);
  // return energy;
  // #wrong shifts-the-weights: a constant power
  // const long steps = power.size() - 1;
  // double energy = 0;
  // for (long i = 0; i <= steps; ++i) {
  //   const bool is_end = i == 0 || i == steps;
  //   energy += h / 3 * power[i] * (is_end ? 1 : i % 2 == 1 ? 2 : 4);
  // }
  // return energy;
  // #wrong takes-midpoints: with half the step
  // double energy = 0;
  // for (long i = 1; i < power.size(); i += 2) energy += 2 * h * power[i];
  // return energy;
  // #endregion
}

// The unexplained energy after one second, J: by the trapezoidal rule, and by
// the better one.
Array2d unexplained(const Model& model, double timestep) {
  model->opt.timestep = timestep;
  const Data data = make_data(model);
  const Eigen::Map<const ArrayXd> damping(model->dof_damping, model->nv);

  const long steps = std::lround(1 / timestep);  // even
  ArrayXd power(steps + 1);
  for (long step = 0; step <= steps; ++step) {
    if (step > 0) mj_step(model, data);
    mj_forward(model, data);
    power[step] = (damping * qvel(model, data).array().square()).sum();
  }
  const Array2d taken(trapezoid(power, timestep), better(power, timestep));
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

  bool is_exact = true;
  for (const int steps : {2, 4, 10})
    is_exact = is_exact &&
               expect_near(better(ArrayXd::Ones(steps + 1), 0.1), 0.1 * steps,
                           1e-12, "a constant power is added up exactly",
                           "the weights must add up to the steps");
  if (is_exact)
    expect_near(order[1], 4, 0.1, "with half the step, a sixteenth is left",
                "this rule is of lower order than the simulation");
}
