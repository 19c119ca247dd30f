// Lesson 3.3, exercise: a torque that the hand does not feel.
//
// INPUT    planar_arm.xml in three poses, with a load or without; any torque
// PROCESS  take out of the torque what accelerates the hand; let MuJoCo say
//          what is left of the hand's acceleration
// OUTPUT   the accelerations; checks the torque
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_3_null_torque

#include <cstdio>
#include <mjcourse/mjcourse.hpp>

#include "l3_3_hand.hpp"

using namespace mjcourse;
using Eigen::Matrix2d, Eigen::Matrix3d, Eigen::Vector2d, Eigen::Vector3d;
using Jacobian = Eigen::Matrix<double, 2, 3>;

// What is left of `torque` when the part that accelerates the hand is gone.
Vector3d unfelt(const Vector3d& torque, const Jacobian& J, const Matrix3d& M) {
  // #region answer
  const Matrix3d inverse = M.inverse();
  const Matrix2d lambda = (J * inverse * J.transpose()).inverse();
  const Vector2d felt = J * inverse * torque;  // the hand's acceleration
  return torque - J.transpose() * lambda * felt;
  // #starter
  // const Matrix2d square = J * J.transpose();  // M is not used yet
  // return torque - J.transpose() * square.inverse() * J * torque;
  // #wrong nothing-is-left: the joints still move
  // return torque - torque.norm() * J.transpose() * J * M * Vector3d::Zero() -
  //        torque;
  // #wrong projects-a-velocity: the hand does not accelerate
  // const Matrix2d lambda = (J * M.inverse() * J.transpose()).inverse();
  // return torque - M.inverse() * J.transpose() * lambda * J * torque;
  // #wrong forgets-the-inverse: the hand does not accelerate
  // const Matrix2d lambda = (J * M * J.transpose()).inverse();
  // return torque - J.transpose() * lambda * J * M * torque;
  // #wrong takes-too-much: what was unfelt stays as it is
  // const Matrix2d lambda = (J * M.inverse() * J.transpose()).inverse();
  // const Vector2d felt = J * M.inverse() * torque;
  // return 0.5 * (torque - J.transpose() * lambda * felt);
  // #endregion
}

int main() {
  const Model model = load_model("planar_arm");
  const Data data = make_data(model), scratch = make_data(model);
  const int sensor = id_of(model, mjOBJ_SENSOR, "hand_acceleration");
  const int body = id_of(model, mjOBJ_BODY, "hand");
  const Vector3d torque(0.1, 0.3, -0.2);
  std::printf("  load  elbow   the hand accelerates with (m/s2)\n");
  std::printf("  (kg)  (rad)   the torque       what is left\n");
  for (const double load : {0.0, 1.0}) {
    model->body_mass[body] = 0.1 + load;
    for (const double elbow : {0.4, 0.9, 2.0}) {
      mj_resetData(model, data);
      data->qpos[1] = elbow;
      mj_forward(model, data);
      const Hand hand = hand_of(model, data, scratch);
      const auto acceleration = [&](const Vector3d& t) {
        ctrl(model, data) = t;
        mj_forward(model, data);
        return Vector2d(data->sensordata + model->sensor_adr[sensor]).norm();
      };
      const Vector3d left = unfelt(torque, hand.J, hand.M);
      const double before = acceleration(torque), after = acceleration(left);
      std::printf("%6.1f %6.1f %12.3f %18.3f\n", load, elbow, before, after);
      const double turns = qacc(model, data).norm();
      if (!expect(std::isfinite(after) && after < 1e-9,
                  "the hand does not accelerate",
                  "which acceleration does the torque give the hand, and "
                  "which force at the hand takes just that away?"))
        continue;
      if (!expect(turns > 0.1, "the joints still move",
                  "a torque of zero is unfelt, too, but moves nothing"))
        continue;
      const Vector3d again = unfelt(left, hand.J, hand.M);
      expect_near(again, left, 1e-9, "what was unfelt stays as it is",
                  "there was nothing to take out: the force at the hand must "
                  "be zero");
    }
  }
}
