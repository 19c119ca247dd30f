// What the programs of lesson 3.4 share: a step of MuJoCo as two matrices, and
// the feedback that LQR makes of them.
//
//   const Linear step = linearise(model, data);  // data at an equilibrium
//   const Eigen::MatrixXd K = lqr(step, Q, R);   // u = u0 - K dx
//
// dx is the change of the state from that equilibrium, 2 nv + na numbers: what
// mj_differentiatePos finds between the two qpos, then the differences of qvel
// and of act.
#pragma once

#include <Eigen/Dense>
#include <mjcourse/mjcourse.hpp>
#include <stdexcept>

namespace mjcourse {

// dx' = A dx + B du, for small changes.
struct Linear {
  Eigen::MatrixXd A, B;
};

// At the state and the controls in `data`, which stay as they are.
inline Linear linearise(const mjModel* model, const mjData* data) {
  using Rows =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const int n = 2 * model->nv + model->na;
  Rows A(n, n), B(n, model->nu);
  const Data scratch = make_data(model);
  mj_copyData(scratch, model, data);
  const double nudge = 1e-6;
  const mjtByte centred = 1;
  mjd_transitionFD(model, scratch, nudge, centred, A.data(), B.data(), nullptr,
                   nullptr);
  return {A, B};
}

// The cost of the best controls from dx on is dx' P dx.
inline Eigen::MatrixXd riccati(const Linear& step, const Eigen::MatrixXd& Q,
                               const Eigen::MatrixXd& R) {
  const auto& [A, B] = step;
  Eigen::MatrixXd P = Q;
  for (int steps = 0; steps < 100000; ++steps) {
    const Eigen::MatrixXd PA = P * A, PB = P * B;
    const Eigen::MatrixXd S = R + B.transpose() * PB;
    const Eigen::MatrixXd K = S.ldlt().solve(PB.transpose() * A);
    const Eigen::MatrixXd next = Q + A.transpose() * (PA - PB * K);
    const double change = (next - P).cwiseAbs().maxCoeff();
    P = (next + next.transpose()) / 2;
    if (change <= 1e-12 * P.cwiseAbs().maxCoeff()) return P;
  }
  throw std::runtime_error("riccati: P does not settle");
}

// The gain K of the controls u0 - K dx that cost least.
inline Eigen::MatrixXd lqr(const Linear& step, const Eigen::MatrixXd& Q,
                           const Eigen::MatrixXd& R) {
  const auto& [A, B] = step;
  const Eigen::MatrixXd PB = riccati(step, Q, R) * B;
  const Eigen::MatrixXd S = R + B.transpose() * PB;
  return S.ldlt().solve(PB.transpose() * A);
}

}  // namespace mjcourse
