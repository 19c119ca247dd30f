// Lesson 1.3, challenge: derivatives that skip what has not changed.
//
// INPUT    arm_and_crate.xml, while the arm pushes the crate
// PROCESS  how does qacc change with each control, velocity and position? By
//          finite differences: once with the whole pipeline for each column,
//          once from the first stage that sees the change. MuJoCo's timers
//          count how often a stage ran
// OUTPUT   these counts, and whether the derivatives are the same bits
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_3_skip

#include <cstdio>
#include <cstring>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;
using Eigen::MatrixXd, Eigen::VectorXd;

struct Derivatives {
  MatrixXd slopes;  // of qacc, a column for each control, velocity, position
  int position_runs = 0, velocity_runs = 0;
};

Derivatives differentiate(const Model& model, const Data& now, bool skip) {
  const int nu = model->nu, nv = model->nv;
  const double small = 1e-6;
  const Data data = make_data(model);
  Derivatives found{MatrixXd(nv, nu + 2 * nv)};
  for (int i = 0; i < nu + 2 * nv; ++i) {
    mj_copyData(data, model, now);  // the state, the warm start, all results
    int known = mjSTAGE_NONE;
    if (i < nu) {
      data->ctrl[i] += small;
      known = mjSTAGE_VEL;  // positions and velocities are what they were
    } else if (i < nu + nv) {
      data->qvel[i - nu] += small;
      known = mjSTAGE_POS;
    } else {
      const VectorXd along = VectorXd::Unit(nv, i - nu - nv);
      mj_integratePos(model, data->qpos, along.data(), small);
    }
    mj_forwardSkip(model, data, skip ? known : mjSTAGE_NONE, 1);
    found.slopes.col(i) = (qacc(model, data) - qacc(model, now)) / small;
    const auto runs = [&](mjtTimer timer) {
      return data->timer[timer].number - now->timer[timer].number;
    };
    found.position_runs += runs(mjTIMER_POSITION);
    found.velocity_runs += runs(mjTIMER_VELOCITY);
  }
  return found;
}

int main() {
  const Model model = load_model("arm_and_crate");
  const Data now = make_data(model);
  ctrl(model, now) << 1.4, 1.8;
  for (int step = 0; step < 300; ++step) mj_step(model, now);
  mj_forward(model, now);

  const Derivatives whole = differentiate(model, now, false);
  const Derivatives skipped = differentiate(model, now, true);
  std::printf("              position  velocity\n");
  std::printf("whole forward %8d  %8d\n", whole.position_runs,
              whole.velocity_runs);
  std::printf("skipping      %8d  %8d\n", skipped.position_runs,
              skipped.velocity_runs);
  const bool same = std::memcmp(whole.slopes.data(), skipped.slopes.data(),
                                sizeof(double) * whole.slopes.size()) == 0;
  std::printf("derivatives: %s\n", same ? "the same bits" : "other bits");
  result("columns", static_cast<double>(whole.slopes.cols()));
  result("whole_position", whole.position_runs);
  result("skipped_position", skipped.position_runs);
}
