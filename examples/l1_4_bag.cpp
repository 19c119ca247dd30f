// Lesson 1.4, exercise: a pull at the hand instead of the centre of mass.
//
// INPUT    three_arms.xml at rest, and 5 N straight down at the middle arm's
//          hand; joint_zoo.xml for other bodies, points and forces
// PROCESS  bring the pull in four ways: J'F, mj_applyFT, and xfrc_applied
//          without and with the torque that moves it to the hand
// OUTPUT   the middle arm's accelerations; checks for several bodies that the
//          three right ways agree within 1e-8
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_4_bag

#include <array>
#include <mjcourse/mjcourse.hpp>
#include <string>

using namespace mjcourse;
using Eigen::Map, Eigen::Vector3d, Eigen::VectorXd;
using Vector6d = Eigen::Vector<double, 6>;
using RowMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// What to write for the same pull through each of two doors.
struct Pull {
  Vector6d wrench;  // into xfrc_applied of the body: force (N), torque (N m)
  VectorXd
      joints;  // into qfrc_applied: N or N m, one for each degree of freedom
};

// A pull at `point` (m) of a body with `force` (N), both in the world frame.
// mj_forward has been called, so data->xipos and all else is there.
Pull pull_at(const Model& model, const Data& data, int body,
             const Vector3d& point, const Vector3d& force) {
  Pull pull{Vector6d::Zero(), VectorXd::Zero(model->nv)};
  // #region answer
  const Vector3d centre(data->xipos + 3 * body);
  pull.wrench << force, (point - centre).cross(force);
  RowMatrix jacobian(3, model->nv);  // of this point of the body
  mj_jac(model, data, jacobian.data(), nullptr, point.data(), body);
  pull.joints = jacobian.transpose() * force;
  // #starter
  // pull.wrench.head<3>() = force;  // acts at the centre of mass
  // pull.joints.setZero();          // the Jacobian's transpose, times force
  // #wrong forgets-the-torque: the wrench acts like
  // pull.wrench.head<3>() = force;
  // RowMatrix jacobian(3, model->nv);
  // mj_jac(model, data, jacobian.data(), nullptr, point.data(), body);
  // pull.joints = jacobian.transpose() * force;
  // #wrong torque-about-the-frame: at the centre of mass
  // const Vector3d origin(data->xpos + 3 * body);
  // pull.wrench << force, (point - origin).cross(force);
  // RowMatrix jacobian(3, model->nv);
  // mj_jac(model, data, jacobian.data(), nullptr, point.data(), body);
  // pull.joints = jacobian.transpose() * force;
  // #wrong jacobian-of-the-centre: the joint forces act like
  // const Vector3d centre(data->xipos + 3 * body);
  // pull.wrench << force, (point - centre).cross(force);
  // RowMatrix jacobian(3, model->nv);
  // mj_jacBodyCom(model, data, jacobian.data(), nullptr, body);
  // pull.joints = jacobian.transpose() * force;
  // #endregion
  return pull;
}

// The accelerations that come of writing these numbers.
VectorXd effect(const Model& model, const Data& data, int body,
                const Vector6d& wrench, const VectorXd& joints) {
  Map<Vector6d>(data->xfrc_applied + 6 * body) = wrench;
  VectorView(data->qfrc_applied, model->nv) = joints;
  mj_forward(model, data);
  return qacc(model, data);
}

// Pulls at the place `offset` of the body's frame, in the pose `way` from the
// first one. Returns the accelerations by J'F, mj_applyFT, wrench, force alone.
std::array<VectorXd, 4> check(const Model& model, const char* name,
                              const Vector3d& offset, const Vector3d& force,
                              double way) {
  const int body = id_of(model, mjOBJ_BODY, name), nv = model->nv;
  const Data data = make_data(model);
  const VectorXd turn = way * VectorXd::LinSpaced(nv, -0.5, 0.7);
  mj_integratePos(model, data->qpos, turn.data(), 1);
  mj_forward(model, data);
  Vector3d point, none(0, 0, 0), centre(data->xipos + 3 * body);
  mju_rotVecMat(point.data(), offset.data(), data->xmat + 9 * body);
  point += Vector3d(data->xpos + 3 * body);

  const Pull pull = pull_at(model, data, body, point, force);
  const Pull there = pull_at(model, data, body, centre, force);
  const VectorXd zero = VectorXd::Zero(nv);
  VectorXd right = zero;
  mj_applyFT(model, data, force.data(), none.data(), point.data(), body,
             right.data());
  Vector6d wrench = Vector6d::Zero();
  const auto by_joints = effect(model, data, body, wrench, pull.joints);
  const auto expected = effect(model, data, body, wrench, right);
  wrench.head<3>() = force;
  const auto alone = effect(model, data, body, wrench, zero);
  const auto by_wrench = effect(model, data, body, pull.wrench, zero);

  const std::string of = std::string(name) + ": ";
  expect_near(by_joints, expected, 1e-8,
              "the joint forces act like a pull at this point",
              of + "mj_jac writes the Jacobian of this point row by row");
  if (expect_near(effect(model, data, body, there.wrench, zero), alone, 1e-8,
                  "at the centre of mass, the wrench is the force alone",
                  of + "the torque is not about the centre of mass"))
    expect_near(by_wrench, expected, 1e-8,
                "the wrench acts like a pull at this point",
                of + "xfrc_applied acts at the centre of mass: a pull at "
                     "this point also turns the body, about that centre");
  return {by_joints, expected, by_wrench, alone};
}

int main() {
  const Model arms = load_model("three_arms"), zoo = load_model("joint_zoo");
  const Vector3d hand(0.25, 0, 0);
  const auto found = check(arms, "middle_fore", hand, {0, 0, -5}, 0);
  print("J'F into qfrc_applied    ", found[0].segment<2>(2));
  print("mj_applyFT               ", found[1].segment<2>(2));
  print("xfrc_applied, with torque", found[2].segment<2>(2));
  print("xfrc_applied, force alone", found[3].segment<2>(2));
  check(arms, "front_upper", {0.1, 0, 0.05}, {3, 0, 1}, 1);
  check(zoo, "ball_pendulum", {0.06, 0.05, -0.3}, {3, -1, 2}, 1);
}
