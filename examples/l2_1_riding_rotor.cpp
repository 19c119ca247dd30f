// Lesson 2.1, challenge: the motor of the elbow rides on the upper arm.
//
// INPUT    two rods and, at the end of the upper one, a rotor: free to turn, or
//          fixed to its rod
// PROCESS  reduce the mass matrix of three joints to that of two, where the
//          rotor turns by gear times elbow; compare with what an armature
//          gives, and with a matrix worked out
// OUTPUT   accelerations when the motor pulls; checks the matrix that was
//          worked out, in two poses and with three gears
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_1_riding_rotor

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <string>

using namespace mjcourse;
using Eigen::Matrix2d, Eigen::Vector2d;

// The mass matrix of shoulder and elbow. `fixed` is the one of an arm whose
// rotor, of the inertia J about its axle, is fixed to the upper rod and turns
// with it. In truth it turns relative to that rod, `gear` times as far as the
// elbow, in the same sense.
Matrix2d with_rotor(const Matrix2d& fixed, double gear, double J) {
  // #region answer
  // J (v0 + gear v1)^2 / 2, less J v0^2 / 2, which `fixed` has.
  Matrix2d rotor;
  rotor << 0, gear * J, gear * J, gear * gear * J;
  return fixed + rotor;
  // #starter
  // Matrix2d rotor;
  // rotor << 0, 0, 0, gear * gear * J;  // MuJoCo's armature
  // return fixed + rotor;
  // #wrong counts-it-twice: it is the mass matrix
  // Matrix2d rotor;
  // rotor << J, gear * J, gear * J, gear * gear * J;
  // return fixed + rotor;
  // #wrong squares-everything: it is the mass matrix
  // Matrix2d rotor;
  // rotor << 0, gear * gear * J, gear * gear * J, gear * gear * J;
  // return fixed + rotor;
  // #wrong turns-against: it is the mass matrix
  // Matrix2d rotor;
  // rotor << 0, -gear * J, -gear * J, gear * gear * J;
  // return fixed + rotor;
  // #endregion
}

// The arm; with a joint for the rotor, or without.
Model arm(const std::string& joint) {
  return load_model_xml(R"(
    <mujoco>
      <option gravity="0 0 0"><flag contact="disable"/></option>
      <default><joint axis="0 -1 0"/></default>
      <worldbody><body>
        <joint name="shoulder"/>
        <geom type="capsule" fromto="0 0 0 0.3 0 0" size="0.02" mass="0.5"/>
        <body pos="0.3 0.1 0">)" +
                        joint + R"(
          <geom type="cylinder" fromto="0 0 0 0 0.003 0" size="0.04"
                mass="0.125"/>
        </body>
        <body pos="0.3 0 0">
          <joint name="elbow"/>
          <geom type="capsule" fromto="0 0 0 0.3 0 0" size="0.02" mass="0.5"/>
        </body>
      </body></worldbody>
    </mujoco>)");
}

Eigen::MatrixXd mass_matrix(const Model& model, double elbow) {
  const Data data = make_data(model);
  data->qpos[model->nq - 1] = elbow;
  mj_forward(model, data);
  Eigen::MatrixXd full(model->nv, model->nv);
  mj_fullM(model, full.data(), data->qM);  // symmetric: rows or columns
  return full;
}

int main() {
  const Model fixed = arm(""), turning = arm("<joint name='rotor'/>");
  const double J = 0.125 * 0.04 * 0.04 / 2, torque = 1;
  std::printf("1 N m of the rotor   shoulder (rad/s2)     elbow (rad/s2)\n");
  std::printf("elbow (rad)  gear    truth  armature     truth  armature\n");
  for (const double elbow : {0.0, 1.5}) {
    for (const double gear : {1.0, 10.0, 100.0}) {
      Eigen::Matrix<double, 3, 2> turns;  // shoulder, rotor, elbow
      turns << 1, 0, 0, gear, 0, 1;
      const Matrix2d truth =
          turns.transpose() * mass_matrix(turning, elbow) * turns;
      const Matrix2d own = mass_matrix(fixed, elbow);
      Matrix2d armature = own;
      armature(1, 1) += gear * gear * J;
      const Vector2d pull(0, gear * torque);
      const Vector2d real = truth.inverse() * pull;
      const Vector2d simple = armature.inverse() * pull;
      std::printf("%11.1f  %4.0f  %7.2f  %8.2f  %8.2f  %8.2f\n", elbow, gear,
                  real[0], simple[0], real[1], simple[1]);
      if (elbow > 0) {
        const std::string n = std::to_string(std::lround(gear));
        result("shoulder_" + n, 100 * std::abs(simple[0] / real[0] - 1));
        result("back_" + n, gear * J * real[1]);
        result("elbow_" + n, 100 * std::abs(simple[1] / real[1] - 1));
      }
      const Matrix2d given = with_rotor(own, gear, J);
      expect_near(
          given.reshaped(), truth.reshaped(), 1e-9,
          "it is the mass matrix of the arm with its rotor",
          "how fast does the rotor turn in space, and which part of its "
          "energy does the fixed rotor have already?");
    }
  }
}
