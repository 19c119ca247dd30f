// Lesson 3.4: what the weights of LQR do to a leg.
//
// INPUT    balancing_leg.xml; weights of 1 on each angle, 0 on the speeds, and
//          R on the torques, from expensive ones to cheap ones
// PROCESS  LQR of MuJoCo's A and B; the same by the formulas; then let the leg
//          go, 5 degrees off, with all the torque that it asks for
// OUTPUT   gains, the damping ratio, the largest torque, and the time until
//          the leg is within a tenth of a degree
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_4_weights

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/lqr.hpp>

using namespace mjcourse;
using Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

constexpr double kInertia = 1.5, kPull = 5 * 9.81 * 0.45;  // kg m^2, N m/rad

MatrixXd gain(const Model& model, double weight) {
  const Data upright = make_data(model);
  MatrixXd Q = MatrixXd::Zero(6, 6);
  Q.diagonal().head<3>().fill(1);
  return lqr(linearise(model, upright), Q, weight * MatrixXd::Identity(3, 3));
}

// #region formulas
// The same for a continuous time: torque = -(angle_gain * angle + ...).
double angle_gain(double weight) {
  return kPull + std::sqrt(kPull * kPull + 1 / weight);
}
double speed_gain(double weight) {
  return std::sqrt(2 * kInertia * angle_gain(weight));
}
// #endregion

struct Fall {
  double torque = 0, settled = 0;  // N m, s
};

Fall let_go(const Model& model, const MatrixXd& K) {
  const Data data = make_data(model);
  const Vector3d y(0, 1, 0);
  mju_axisAngle2Quat(data->qpos, y.data(), 5 * M_PI / 180);
  Fall fall;
  while (data->time < 4) {
    VectorXd dx(6);
    mj_differentiatePos(model, dx.data(), 1, model->qpos0, data->qpos);
    dx.tail<3>() = qvel(model, data);
    ctrl(model, data) = -K * dx;
    if (std::abs(dx[1]) > 0.1 * M_PI / 180) fall.settled = data->time;
    fall.torque = std::max(fall.torque, ctrl(model, data).norm());
    mj_step(model, data);
  }
  return fall;
}

int main() {
  const Model model = load_model("balancing_leg");
  for (int i = 0; i < 3; ++i) model->actuator_forcelimited[i] = 0;
  std::printf("            gains        by formula   damping  torque  calm\n");
  std::printf("     R  angle  speed   angle  speed     ratio   (N m)   (s)\n");
  Fall first, last;
  for (const double weight : {1.0, 1e-2, 1e-3, 1e-4, 1e-5}) {
    const MatrixXd K = gain(model, weight);
    const Fall fall = let_go(model, K);
    const double stiffness = K(1, 1) - kPull;
    const double ratio = K(1, 4) / (2 * std::sqrt(kInertia * stiffness));
    std::printf("%6.0e  %5.1f  %5.1f   %5.1f  %5.1f  %8.2f  %6.1f  %4.2f\n",
                weight, K(1, 1), K(1, 4), angle_gain(weight),
                speed_gain(weight), ratio, fall.torque, fall.settled);
    if (weight == 1) first = fall;
    last = fall;
  }

  result("quicker", first.settled / last.settled);
  result("stronger", last.torque / first.torque);
}
