// Lesson 1.3, challenge: derivatives that skip what has not changed.
//
// INPUT    arm_and_crate.xml, while the arm pushes the crate
// PROCESS  how does qacc change with each control, velocity and position? By
//          finite differences: once with the whole pipeline for each column,
//          once from the first stage that sees the change. MuJoCo's timers
//          count how often a stage ran
// OUTPUT   these counts, and whether the derivatives are the same bits; checks
//          both, and what each column changes
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_3_skip

#include <cstdio>
#include <cstring>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;
using Eigen::MatrixXd, Eigen::VectorXd;

enum Kind { control, velocity, position };
const double small = 1e-6;

// Adds `small` to control k, to velocity k, or to the position along degree of
// freedom k; then computes qacc, and runs no stage that it need not run. `data`
// is a whole copy of a state after mj_forward.
void change(const Model& model, const Data& data, Kind kind, int k) {
  // #region answer
  int known = mjSTAGE_NONE;
  if (kind == control) {
    data->ctrl[k] += small;
    known = mjSTAGE_VEL;  // positions and velocities are what they were
  } else if (kind == velocity) {
    data->qvel[k] += small;
    known = mjSTAGE_POS;
  } else {
    const VectorXd along = VectorXd::Unit(model->nv, k);
    mj_integratePos(model, data->qpos, along.data(), small);
  }
  mj_forwardSkip(model, data, known, 1);
  // #starter
  // if (kind == control) data->ctrl[k] += small;
  // // Change velocities and positions too. And which stages need not run?
  // // The 1 skips the sensors.
  // mj_forwardSkip(model, data, mjSTAGE_NONE, 1);
  // #wrong adds-to-qpos: each column changes one number
  // const int known[] = {mjSTAGE_VEL, mjSTAGE_POS, mjSTAGE_NONE};
  // if (kind == control) data->ctrl[k] += small;
  // if (kind == velocity) data->qvel[k] += small;
  // if (kind == position) data->qpos[k] += small;
  // mj_forwardSkip(model, data, known[kind], 1);
  // #wrong skips-too-much: not a bit of qacc
  // const VectorXd along = VectorXd::Unit(model->nv, k);
  // if (kind == control) data->ctrl[k] += small;
  // if (kind == velocity) data->qvel[k] += small;
  // if (kind == position)
  //   mj_integratePos(model, data->qpos, along.data(), small);
  // const int known = kind == position ? mjSTAGE_NONE : mjSTAGE_VEL;
  // mj_forwardSkip(model, data, known, 1);
  // #wrong controls-like-velocities: a stage runs only
  // const VectorXd along = VectorXd::Unit(model->nv, k);
  // if (kind == control) data->ctrl[k] += small;
  // if (kind == velocity) data->qvel[k] += small;
  // if (kind == position)
  //   mj_integratePos(model, data->qpos, along.data(), small);
  // const int known = kind == position ? mjSTAGE_NONE : mjSTAGE_POS;
  // mj_forwardSkip(model, data, known, 1);
  // #endregion
}

// How far the numbers of one kind have come from what they were.
VectorXd changed(const Model& model, const Data& now, const Data& data,
                 Kind kind) {
  if (kind == control) return ctrl(model, data) - ctrl(model, now);
  if (kind == velocity) return qvel(model, data) - qvel(model, now);
  VectorXd along(model->nv);
  mj_differentiatePos(model, along.data(), 1, now->qpos, data->qpos);
  return along;
}

int main() {
  const Model model = load_model("arm_and_crate");
  const Data now = make_data(model);
  ctrl(model, now) << 1.4, 1.8;
  for (int step = 0; step < 300; ++step) mj_step(model, now);
  mj_forward(model, now);

  const Data some = make_data(model), all = make_data(model);
  const int nu = model->nu, nv = model->nv, size = nu + 2 * nv;
  MatrixXd skipped(nv, size), whole(nv, size);
  int column = 0, some_runs[2] = {}, all_runs[2] = {};
  bool own = true;
  for (const Kind kind : {control, velocity, position}) {
    const int count = kind == control ? nu : nv;
    for (int k = 0; k < count; ++k, ++column) {
      mj_copyData(some, model, now);  // the state, the warm start, all results
      change(model, some, kind, k);
      own = own && expect_near(changed(model, now, some, kind) / small,
                               VectorXd::Unit(count, k), 1e-3,
                               "each column changes one number by a millionth",
                               "count along degrees of freedom; a quaternion "
                               "has four numbers for three of them");
      mj_copyData(all, model, now);  // and the same change, skipping nothing
      qpos(model, all) = qpos(model, some);
      qvel(model, all) = qvel(model, some);
      ctrl(model, all) = ctrl(model, some);
      mj_forward(model, all);
      skipped.col(column) = (qacc(model, some) - qacc(model, now)) / small;
      whole.col(column) = (qacc(model, all) - qacc(model, now)) / small;
      for (const int i : {0, 1}) {
        const int timer = i == 0 ? mjTIMER_POSITION : mjTIMER_VELOCITY;
        some_runs[i] += some->timer[timer].number - now->timer[timer].number;
        all_runs[i] += all->timer[timer].number - now->timer[timer].number;
      }
    }
  }
  std::printf("              position  velocity\n");
  std::printf("whole forward %8d  %8d\n", all_runs[0], all_runs[1]);
  std::printf("skipping      %8d  %8d\n", some_runs[0], some_runs[1]);
  const bool same = std::memcmp(whole.data(), skipped.data(),
                                sizeof(double) * whole.size()) == 0;
  std::printf("derivatives: %s\n", same ? "the same bits" : "other bits");
  result("columns", size);
  result("whole_position", all_runs[0]);
  result("skipped_position", some_runs[0]);
  if (own && expect(same, "not a bit of qacc is another for skipping",
                    "a stage is skipped that this change affects"))
    expect(some_runs[0] == nv && some_runs[1] == 2 * nv,
           "a stage runs only where its inputs have changed",
           "more can be skipped: what do positions and velocities depend on?");
}
