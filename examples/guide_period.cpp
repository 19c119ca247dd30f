// Author guide: an exercise, with all that belongs to it.
//
// INPUT    a pendulum of 1 m in the program itself
// PROCESS  compute the period of a small swing; simulate one from an end to the
//          same end
// OUTPUT   the computed period; checks it against the simulated one, and how it
//          depends on the length

#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

// The period (s) of a small swing of a point mass on a rod of `length` (m),
// where gravity is `g` (m/s^2).
double period(double length, double g) {
  // #region answer
  return 2 * M_PI * std::sqrt(length / g);
  // #starter
  // return 1;  // longer rods are slower
  // #wrong half-a-swing: the pendulum is back
  // return M_PI * std::sqrt(length / g);
  // #wrong no-root: four times the rod
  // return 2 * M_PI * length / std::sqrt(g);
  // #endregion
}

// How long a pendulum of length 1 m takes from one end to the same end.
double counted_period() {
  const Model model = load_model_xml(R"(
<mujoco>
  <option timestep="0.0005" integrator="RK4"/>
  <worldbody><body>
    <joint name="hinge" axis="0 1 0"/>
    <geom type="sphere" size="0.01" pos="0 0 -1" mass="1"/>
  </body></worldbody>
</mujoco>)");
  const Data data = make_data(model);
  qpos(model, data)[0] = 0.01;  // rad
  int turns = 0;
  double speed = 0;
  while (turns < 2 && data->time < 10) {
    mj_step(model, data);
    if (speed * qvel(model, data)[0] < 0) ++turns;
    speed = qvel(model, data)[0];
  }
  return data->time;
}

int main() {
  std::printf("period of a rod of 1 m: %.2f s\n", period(1, 9.81));
  if (!expect_near(period(1, 9.81), counted_period(), 0.002,
                   "the pendulum is back where it began",
                   "a period is the way there and back"))
    return 0;
  for (const double length : {0.5, 1.0, 2.0})
    expect_near(period(4 * length, 9.81), 2 * period(length, 9.81), 1e-9,
                "four times the rod is twice the period",
                "the length stands under a root");
}
