// Lesson 3.4: one gain, and three ways to say how far off the leg is.
//
// INPUT    balancing_leg.xml; LQR's gain for weights of 1 on each angle and on
//          each torque
// PROCESS  lean the leg by 5 degrees and feed its error back for three seconds;
//          as a rotation vector, and as a difference of quaternions, both also
//          with the quaternion's other name
// OUTPUT   how far it leans then; the gain, and the pull of gravity
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_4_three_errors

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/lqr.hpp>

using namespace mjcourse;
using Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

// #region errors
using Error = Vector3d (*)(const mjModel*, const mjData*);

Vector3d rotation_vector(const mjModel* model, const mjData* data) {
  Vector3d error;
  mj_differentiatePos(model, error.data(), 1, model->qpos0, data->qpos);
  return error;
}

Vector3d subtracted(const mjModel* model, const mjData* data) {
  Vector3d error;
  for (int i = 0; i < 3; ++i)  // x, y, z of the quaternion, without its w
    error[i] = data->qpos[1 + i] - model->qpos0[1 + i];
  return error;
}
// #endregion

// #region balance
// How far the leg leans after three seconds, in degrees.
double balance(const Model& model, const MatrixXd& K, Error error, int sign) {
  const Data data = make_data(model);
  const Vector3d y(0, 1, 0);
  mju_axisAngle2Quat(data->qpos, y.data(), 5 * M_PI / 180);
  qpos(model, data) *= sign;
  for (int step = 0; step < 1500; ++step) {
    VectorXd dx(2 * model->nv);
    dx << error(model, data), qvel(model, data);
    ctrl(model, data) = -K * dx;
    mj_step(model, data);
  }
  mj_forward(model, data);
  const double up = data->xmat[9 * id_of(model, mjOBJ_BODY, "leg") + 8];
  return std::acos(std::min(up, 1.0)) * 180 / M_PI;
}
// #endregion

int main() {
  const Model model = load_model("balancing_leg");
  const Data upright = make_data(model);
  MatrixXd Q = MatrixXd::Zero(6, 6);
  Q.diagonal().head<3>().fill(1);  // on the angles
  const MatrixXd R = MatrixXd::Identity(3, 3);
  const MatrixXd K = lqr(linearise(model, upright), Q, R);

  std::printf("error                quaternion  leans by\n");
  const auto show = [&](const char* name, const char* key, Error error,
                        int sign) {
    const double left = balance(model, K, error, sign);
    std::printf("%-19s  %10s  %5.2f degrees\n", name, sign > 0 ? "q" : "-q",
                left);
    result(key, left);
  };
  show("mj_differentiatePos", "whole", rotation_vector, 1);
  show("mj_differentiatePos", "whole_other", rotation_vector, -1);
  show("qpos subtracted", "subtracted", subtracted, 1);
  show("qpos subtracted", "subtracted_other", subtracted, -1);

  const double pull =
      -model->opt.gravity[2] * model->body_mass[1] * model->body_ipos[5];
  std::printf("gain, for an angle  %5.2f N m/rad\n", K(1, 1));
  std::printf("half of it          %5.2f N m/rad\n", K(1, 1) / 2);
  std::printf("gravity             %5.2f N m/rad\n", pull);
  result("gain", K(1, 1));
  result("half", K(1, 1) / 2);
  result("gain_speed", K(1, 4));
  result("gravity", pull);
}
