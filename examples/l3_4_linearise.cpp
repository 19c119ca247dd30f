// Lesson 3.4, exercise: the matrix A by finite differences.
//
// INPUT    balancing_leg.xml, leaning; drone.xml, tumbling; arm_and_crate.xml,
//          pushing: each has a quaternion in its qpos
// PROCESS  nudge each number of a change both ways, take a step, subtract
// OUTPUT   sizes, and how far off mjd_transitionFD that is; checks the columns
//          for qvel, for act and for qpos
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_4_linearise

#include <cmath>
#include <cstdio>
#include <mjcourse/lqr.hpp>

using namespace mjcourse;
using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

// The change from one state to another: nv numbers for qpos, nv for qvel, na
// for act.
VectorXd difference(const mjModel* model, const mjData* from,
                    const mjData* to) {
  const int nv = model->nv, na = model->na;
  VectorXd dx(2 * nv + na);
  mj_differentiatePos(model, dx.data(), 1, from->qpos, to->qpos);
  mju_sub(dx.data() + nv, to->qvel, from->qvel, nv);
  mju_sub(dx.data() + 2 * nv, to->act, from->act, na);
  return dx;
}

// A at the state in `start`: column i says how the state after a step changes,
// for each unit by which number i of the change is nudged. Centred differences
// with nudges of eps.
MatrixXd transition(const mjModel* model, const mjData* start, double eps) {
  // #region answer
  const int nv = model->nv, na = model->na, n = 2 * nv + na;
  const auto step = [&](mjData* data, int i, double by) {
    VectorXd dx = VectorXd::Zero(n);
    dx[i] = by;
    mj_copyData(data, model, start);
    mj_integratePos(model, data->qpos, dx.data(), 1);
    mju_addTo(data->qvel, dx.data() + nv, nv);
    mju_addTo(data->act, dx.data() + 2 * nv, na);
    mj_step(model, data);
  };
  const Data plus = make_data(model), minus = make_data(model);
  MatrixXd A(n, n);
  for (int i = 0; i < n; ++i) {
    step(plus, i, eps);
    step(minus, i, -eps);
    A.col(i) = difference(model, minus, plus) / (2 * eps);
  }
  return A;
  // #starter
  // const int n = model->nq + model->nv + model->na;  // is it?
  // return MatrixXd::Zero(n, n);
  // #wrong a-column-for-each-number-of-qpos: there is a row and a column
  // const int nq = model->nq, n = nq + model->nv + model->na;
  // const Data plus = make_data(model), minus = make_data(model);
  // MatrixXd A(2 * model->nv + model->na, n);
  // for (int i = 0; i < n; ++i) {
  //   for (mjData* data : {(mjData*)plus, (mjData*)minus}) {
  //     mj_copyData(data, model, start);
  //     const double by = data == plus ? eps : -eps;
  //     (i < nq ? data->qpos[i] : data->qvel[i - nq]) += by;
  //     mj_step(model, data);
  //   }
  //   A.col(i) = difference(model, minus, plus) / (2 * eps);
  // }
  // return A;
  // #wrong forgets-act: there is a row and a column
  // const int nv = model->nv;
  // const Data plus = make_data(model), minus = make_data(model);
  // MatrixXd A(2 * nv, 2 * nv);
  // for (int i = 0; i < 2 * nv; ++i) {
  //   for (mjData* data : {(mjData*)plus, (mjData*)minus}) {
  //     const double by = data == plus ? eps : -eps;
  //     VectorXd dx = VectorXd::Zero(nv);
  //     mj_copyData(data, model, start);
  //     (i < nv ? dx[i] : data->qvel[i - nv]) += by;
  //     mj_integratePos(model, data->qpos, dx.data(), 1);
  //     mj_step(model, data);
  //   }
  //   A.col(i) = difference(model, minus, plus).head(2 * nv) / (2 * eps);
  // }
  // return A;
  // #wrong forward: the columns for qpos
  // const int nv = model->nv, na = model->na, n = 2 * nv + na;
  // const Data plus = make_data(model), here = make_data(model);
  // mj_copyData(here, model, start);
  // mj_step(model, here);
  // MatrixXd A(n, n);
  // for (int i = 0; i < n; ++i) {
  //   VectorXd dx = VectorXd::Zero(n);
  //   dx[i] = eps;
  //   mj_copyData(plus, model, start);
  //   mj_integratePos(model, plus->qpos, dx.data(), 1);
  //   mju_addTo(plus->qvel, dx.data() + nv, nv);
  //   mju_addTo(plus->act, dx.data() + 2 * nv, na);
  //   mj_step(model, plus);
  //   A.col(i) = difference(model, here, plus) / eps;
  // }
  // return A;
  // #wrong nudges-twice-as-far: the columns for qvel
  // const int nv = model->nv, na = model->na, n = 2 * nv + na;
  // const Data plus = make_data(model), minus = make_data(model);
  // MatrixXd A(n, n);
  // for (int i = 0; i < n; ++i) {
  //   for (mjData* data : {(mjData*)plus, (mjData*)minus}) {
  //     VectorXd dx = VectorXd::Zero(n);
  //     dx[i] = data == plus ? eps : -eps;
  //     mj_copyData(data, model, start);
  //     mj_integratePos(model, data->qpos, dx.data(), 1);
  //     mju_addTo(data->qvel, dx.data() + nv, nv);
  //     mju_addTo(data->act, dx.data() + 2 * nv, na);
  //     mj_step(model, data);
  //   }
  //   A.col(i) = difference(model, minus, plus) / eps;
  // }
  // return A;
  // #wrong adds-to-qpos: the columns for qpos
  // const int nv = model->nv, na = model->na, n = 2 * nv + na;
  // const Data plus = make_data(model), minus = make_data(model);
  // MatrixXd A(n, n);
  // for (int i = 0; i < n; ++i) {
  //   for (mjData* data : {(mjData*)plus, (mjData*)minus}) {
  //     VectorXd dx = VectorXd::Zero(n);
  //     dx[i] = data == plus ? eps : -eps;
  //     mj_copyData(data, model, start);
  //     mju_addTo(data->qpos, dx.data(), nv);
  //     mju_addTo(data->qvel, dx.data() + nv, nv);
  //     mju_addTo(data->act, dx.data() + 2 * nv, na);
  //     mj_step(model, data);
  //   }
  //   A.col(i) = difference(model, minus, plus) / (2 * eps);
  // }
  // return A;
  // #wrong leaves-act-alone: the columns for act
  // const int nv = model->nv, na = model->na, n = 2 * nv + na;
  // const Data plus = make_data(model), minus = make_data(model);
  // MatrixXd A(n, n);
  // for (int i = 0; i < n; ++i) {
  //   for (mjData* data : {(mjData*)plus, (mjData*)minus}) {
  //     VectorXd dx = VectorXd::Zero(n);
  //     dx[i] = data == plus ? eps : -eps;
  //     mj_copyData(data, model, start);
  //     mj_integratePos(model, data->qpos, dx.data(), 1);
  //     mju_addTo(data->qvel, dx.data() + nv, nv);
  //     mj_step(model, data);
  //   }
  //   A.col(i) = difference(model, minus, plus) / (2 * eps);
  // }
  // return A;
  // #endregion
}

constexpr double kNudge = 1e-4;  // large enough to tell the ways apart

// False after the first check that fails.
bool check(const char* name) {
  const Model model = load_model(name);
  const Data start = make_data(model);
  if (model->nkey > 0) mj_resetDataKeyframe(model, start, 0);
  for (int i = 0; i < model->nv; ++i) start->qvel[i] = 0.5 * std::sin(i + 1);
  for (int i = 0; i < model->nu; ++i) start->ctrl[i] += 0.2 * i;
  for (int step = 0; step < 100; ++step) mj_step(model, start);

  const int nv = model->nv, na = model->na, n = 2 * nv + na;
  using Rows =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Rows theirs(n, n);
  const Data scratch = make_data(model);
  mj_copyData(scratch, model, start);
  mjd_transitionFD(model, scratch, kNudge, 1, theirs.data(), nullptr, nullptr,
                   nullptr);
  const MatrixXd own = transition(model, start, kNudge);

  if (!expect(own.rows() == n && own.cols() == n,
              "there is a row and a column for each number of a change",
              "a change has nv numbers for qpos, nv for qvel and na for act"))
    return false;
  const double off = (own - theirs).cwiseAbs().maxCoeff();
  std::printf("%-13s  %2d  %3ld x %-3ld  %s\n", name,
              model->nq + model->nv + model->na, own.rows(), own.cols(),
              off < 1e-10 ? "yes" : "no");
  const auto agree = [&](int from, int count, const char* what,
                         const char* meaning) {
    return count == 0 || expect_near(own.middleCols(from, count).reshaped(),
                                     theirs.middleCols(from, count).reshaped(),
                                     1e-10, what, meaning);
  };
  return agree(nv, nv, "the columns for qvel are those of mjd_transitionFD",
               "nudge both ways, and divide by the distance of the two") &&
         agree(2 * nv, na, "the columns for act are those of mjd_transitionFD",
               "the thrust of a rotor is part of the state") &&
         agree(0, nv, "the columns for qpos are those of mjd_transitionFD",
               "a pose is nudged by mj_integratePos");
}

int main() {
  std::printf("model      numbers     A      within 1e-10\n");
  for (const char* name : {"balancing_leg", "drone", "arm_and_crate"})
    if (!check(name)) return 0;
}
