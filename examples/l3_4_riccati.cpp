// Lesson 3.4: the Riccati equation, solved twice.
//
// INPUT    balancing_leg.xml, upright; drone.xml, hovering
// PROCESS  repeat the Riccati step until P stays as it is; take the stable
//          eigenvectors of the symplectic matrix; compare both; keep the gain
//          of each horizon on the way
// OUTPUT   steps, eigenvalues, and how far apart the two gains are; for the
//          lesson, the table "horizons"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_4_riccati

#include <cmath>
#include <cstdio>
#include <mjcourse/lqr.hpp>
#include <vector>

using namespace mjcourse;
using Eigen::EigenSolver, Eigen::MatrixXcd, Eigen::MatrixXd;

// #region step
MatrixXd gain(const Linear& step, const MatrixXd& P, const MatrixXd& R) {
  const auto& [A, B] = step;
  const MatrixXd S = R + B.transpose() * P * B;
  return S.ldlt().solve(B.transpose() * P * A);
}

// From the cost that is left after a step to the cost before it.
MatrixXd one_step_earlier(const Linear& step, const MatrixXd& P,
                          const MatrixXd& Q, const MatrixXd& R) {
  const auto& [A, B] = step;
  const MatrixXd K = gain(step, P, R);
  const MatrixXd before = Q + A.transpose() * P * (A - B * K);
  return (before + before.transpose()) / 2;  // keeps it symmetric
}
// #endregion

// #region eigenvectors
// P from the eigenvectors that die out, and how many these are.
struct Stable {
  MatrixXd P;
  long count = 0;
};

Stable by_eigenvectors(const Linear& step, const MatrixXd& Q,
                       const MatrixXd& R) {
  const auto& [A, B] = step;
  const long n = A.rows();
  const MatrixXd G = B * R.inverse() * B.transpose();
  const MatrixXd back = A.transpose().inverse();
  MatrixXd S(2 * n, 2 * n);
  S << A + G * back * Q, -G * back, -back * Q, back;

  const EigenSolver<MatrixXd> solver(S);
  MatrixXcd stable(2 * n, n);
  long count = 0;
  for (long i = 0; i < 2 * n; ++i)
    if (std::abs(solver.eigenvalues()[i]) < 1 && ++count <= n)
      stable.col(count - 1) = solver.eigenvectors().col(i);
  const MatrixXcd P = stable.bottomRows(n) * stable.topRows(n).inverse();
  return {P.real(), count};
}
// #endregion

void compare(const char* name, const Model& model, const Data& data,
             const MatrixXd& Q, const MatrixXd& R, bool follow) {
  const Linear step = linearise(model, data);
  const double h = model->opt.timestep;
  std::vector<double> horizons, gains;
  MatrixXd P = Q;
  int steps = 0;
  for (double change = 1; change > 1e-12; ++steps) {
    const MatrixXd earlier = one_step_earlier(step, P, Q, R);
    change = (earlier - P).cwiseAbs().maxCoeff() / P.cwiseAbs().maxCoeff();
    P = earlier;
    if (follow && steps % 10 == 9 && steps < 1000) {
      const MatrixXd K = gain(step, P, R);
      horizons.push_back((steps + 1) * h);
      gains.push_back(K(1, 1));
    }
  }
  const auto [found, stable] = by_eigenvectors(step, Q, R);
  const MatrixXd K = gain(step, P, R), other = gain(step, found, R);
  const double apart = (K - other).norm() / K.norm();
  std::printf("%-5s  %3ld x %-3ld  %5d  %10ld of %-3ld  %s\n", name,
              step.A.rows(), step.A.cols(), steps, stable, 2 * step.A.rows(),
              apart < 1e-6 ? "yes" : "no");
  if (!follow) return;
  result("steps", steps);
  result("foresight", steps * h);
  const std::vector<double> gravity(gains.size(), 5 * 9.81 * 0.45);
  table("horizons",
        {{"horizon", horizons}, {"gain", gains}, {"gravity", gravity}});
  std::size_t enough = 0;  // the first gain that balances
  while (gains[enough] < gravity[enough]) ++enough;
  result("shortest", horizons[enough]);
}

int main() {
  std::printf("       A          steps  eigenvectors     same K\n");
  const Model leg = load_model("balancing_leg");
  const Data upright = make_data(leg);
  MatrixXd Q = MatrixXd::Zero(6, 6);
  Q.diagonal().head<3>().fill(1);  // on the angles
  compare("leg", leg, upright, Q, MatrixXd::Identity(3, 3), true);

  const Model drone = load_model("drone");
  const Data hovering = make_data(drone);
  mj_resetDataKeyframe(drone, hovering, 0);
  Q = MatrixXd::Zero(16, 16);
  Q.diagonal().head<6>().fill(1);  // on the pose
  compare("drone", drone, hovering, Q, 0.001 * MatrixXd::Identity(4, 4), false);
}
