// Lesson 2.4: a loop that a connect closes.
//
// INPUT    four_bar.xml: three hinges, and a connect between two bars' ends
// PROCESS  turn the crank at several speeds and measure the gap in the loop; do
//          so without the connect's spring
// OUTPUT   the largest gaps, and those of a formula; for the lesson, the gaps
//          over time as the table "drift"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_4_four_bar

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;

using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

// #region gap
// The gap at which the spring makes up for the loop's own acceleration
// and for the force that it carries.
Eigen::Vector3d formula(const Model& model, const Data& data,
                        const Data& later) {
  const double small = 1e-6;  // s
  mju_copy(later->qpos, data->qpos, model->nq);
  mj_integratePos(model, later->qpos, data->qvel, small);
  mj_fwdPosition(model, later);
  const Rows change = Rows(later->efc_J) - Rows(data->efc_J);
  const Eigen::Vector3d v(data->qvel), force(data->efc_force);
  const double k = data->efc_KBIP[0] * data->efc_KBIP[2];
  return (change / small * v - data->efc_R[0] * force) / k;
}
// #endregion

struct Gap {
  double measured = 0, formula = 0;  // m, the largest in a turn
};

Gap turn(const Model& model, double turns, double time) {
  model->eq_solref[0] = time;
  const Data data = make_data(model), later = make_data(model);
  data->ctrl[0] = 2 * M_PI * turns;
  Gap gap;
  while (data->time < 1 + 1 / turns) {
    mj_step(model, data);
    if (data->time < 1) continue;
    mj_forward(model, data);
    gap.measured = std::max(gap.measured, mju_norm3(data->efc_pos));
    gap.formula = std::max(gap.formula, formula(model, data, later).norm());
  }
  return gap;
}

int main() {
  const Model model = load_model("four_bar");
  std::printf("turns/s  time constant (s)  gap (mm)  formula (mm)\n");
  for (const double time : {0.02, 0.01, 0.005}) {
    for (const double turns : {0.5, 1.0, 2.0}) {
      const Gap gap = turn(model, turns, time);
      std::printf("%7.1f  %17.3f  %8.3f  %12.3f\n", turns, time,
                  1000 * gap.measured, 1000 * gap.formula);
      if (turns == 1 && time == 0.01)
        result("at_one_short", 1000 * gap.measured);
      if (turns == 2 && time == 0.02) result("at_two", 1000 * gap.measured);
    }
  }

  const auto drift = [&](double stiffness, double damping) {
    model->eq_solref[0] = -stiffness;
    model->eq_solref[1] = -damping;
    const Data data = make_data(model);
    data->ctrl[0] = 2 * M_PI;
    std::vector<double> gaps;
    for (int step = 0; step <= 10000; ++step, mj_step(model, data)) {
      if (step % 50 != 0) continue;
      mj_forward(model, data);
      gaps.push_back(1000 * mju_norm3(data->efc_pos));
    }
    return gaps;
  };
  // What solref="0.02 1" comes to, then no stiffness at all.
  const std::vector<double> spring = drift(2500, 100), none = drift(0, 100);
  std::vector<double> times;
  for (std::size_t i = 0; i < spring.size(); ++i) times.push_back(0.025 * i);
  std::printf("after 5 s: %.1f mm, and without stiffness %.0f mm\n",
              spring.back(), none.back());
  result("drifted", none.back());
  table("drift", {{"time", times}, {"spring", spring}, {"none", none}});
}
