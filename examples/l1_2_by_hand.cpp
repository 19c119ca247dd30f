// Lesson 1.2, challenge: the velocity of a free joint, by quaternion algebra.
//
// INPUT    joint_zoo.xml; its free box, thrown so that it tumbles
// PROCESS  for each step of MuJoCo's Euler: from the poses before and after it,
//          recover the velocity by mj_differentiatePos and by hand, and compare
//          them with each other and with qvel on both sides of the step
// OUTPUT   the largest differences, or that they are below 1e-12; checks the
//          velocity by hand, also at rest and with the opposite quaternion
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_2_by_hand

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;
using Eigen::Quaterniond, Eigen::VectorXd;
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Vector7d = Eigen::Matrix<double, 7, 1>;

// The velocity that carries a free joint from one pose to another in `dt`
// seconds, as MuJoCo has it in qvel: linear in the world's frame (m/s), then
// angular in the body's own frame (rad/s). A pose is the joint's seven numbers
// of qpos. The body turns the short way round, by at most half a turn.
Vector6d free_joint_velocity(const Vector7d& from, const Vector7d& to,
                             double dt) {
  const Quaterniond q1(from[3], from[4], from[5], from[6]);  // w, x, y, z
  const Quaterniond q2(to[3], to[4], to[5], to[6]);
  Vector6d v;
  v.head<3>() = (to.head<3>() - from.head<3>()) / dt;
  // #region answer
  Quaterniond turn = q1.conjugate() * q2;
  if (turn.w() < 0)
    turn.coeffs() *= -1;  // of q and -q take the short way round
  const double sine = turn.vec().norm();  // of half the angle
  const double angle = 2 * std::atan2(sine, turn.w());
  const double scale = sine > 0 ? angle / sine : 2;  // at rest, its limit
  v.tail<3>() = turn.vec() * (scale / dt);
  // #starter
  // // The turn from q1 to q2 is a quaternion, too; its logarithm over dt.
  // v.tail<3>().setZero();
  // #wrong world-frame: a tumbling box has MuJoCo's velocity
  // Quaterniond turn = q2 * q1.conjugate();
  // if (turn.w() < 0) turn.coeffs() *= -1;
  // const double sine = turn.vec().norm();
  // const double scale = sine > 0 ? 2 * std::atan2(sine, turn.w()) / sine : 2;
  // v.tail<3>() = turn.vec() * (scale / dt);
  // #wrong half-the-angle: a tumbling box has MuJoCo's velocity
  // Quaterniond turn = q1.conjugate() * q2;
  // if (turn.w() < 0) turn.coeffs() *= -1;
  // const double sine = turn.vec().norm();
  // const double scale = sine > 0 ? std::atan2(sine, turn.w()) / sine : 1;
  // v.tail<3>() = turn.vec() * (scale / dt);
  // #wrong long-way: the opposite quaternion is the same pose
  // const Quaterniond turn = q1.conjugate() * q2;
  // const double sine = turn.vec().norm();
  // const double scale = sine > 0 ? 2 * std::atan2(sine, turn.w()) / sine : 2;
  // v.tail<3>() = turn.vec() * (scale / dt);
  // #wrong arc-cosine: the velocity has all its digits
  // Quaterniond turn = q1.conjugate() * q2;
  // if (turn.w() < 0) turn.coeffs() *= -1;
  // const Eigen::Vector3d vec = turn.vec();
  // const double angle = 2 * std::acos(std::min(turn.w(), 1.0));
  // v.tail<3>() = angle / dt * vec.normalized();
  // #wrong divides-by-0: at rest the velocity is 0
  // Quaterniond turn = q1.conjugate() * q2;
  // if (turn.w() < 0) turn.coeffs() *= -1;
  // const double sine = turn.vec().norm();
  // v.tail<3>() = turn.vec() / sine * (2 * std::atan2(sine, turn.w()) / dt);
  // #endregion
  return v;
}

int main() {
  const Model model = load_model("joint_zoo");
  const Data data = make_data(model);
  const int joint = id_of(model, mjOBJ_JOINT, "free");
  const int qadr = model->jnt_qposadr[joint], vadr = model->jnt_dofadr[joint];
  // Not along the world's axes: there, both frames are the same.
  qpos(model, data).segment<4>(qadr + 3) << 0.5, 0.5, -0.5, 0.5;
  qvel(model, data).segment<6>(vadr) << 0.1, 0, 0, 0.5, 1, 2;

  const double h = model->opt.timestep;
  double at_start = 0, at_end = 0, by_hand = 0;  // largest differences
  while (data->time < 2) {
    const VectorXd q1 = qpos(model, data), v1 = qvel(model, data);
    mj_step(model, data);
    const VectorXd q2 = qpos(model, data), v2 = qvel(model, data);

    VectorXd v(model->nv);
    mj_differentiatePos(model, v.data(), h, q1.data(), q2.data());
    at_start = std::max(at_start, (v - v1).norm());
    at_end = std::max(at_end, (v - v2).norm());
    const Vector7d from = q1.segment<7>(qadr);
    Vector7d to = q2.segment<7>(qadr);
    const Vector6d mujoco = v.segment<6>(vadr);
    const Vector6d hand = free_joint_velocity(from, to, h);
    by_hand = std::max(by_hand, (hand - mujoco).norm());
    if (!expect_near(hand, mujoco, 1e-6, "a tumbling box has MuJoCo's velocity",
                     "the angle or the frame of its turn is another one") ||
        !expect_near(hand, mujoco, 1e-12, "the velocity has all its digits",
                     "near w = 1, an arc cosine loses half of them; an arc "
                     "tangent of the sine and the cosine does not"))
      continue;
    to.tail<4>() *= -1;
    expect_near(free_joint_velocity(from, to, h), mujoco, 1e-12,
                "the opposite quaternion is the same pose",
                "the body turns the long way round");
  }
  Vector7d pose = Vector7d::Zero();
  pose[3] = 1;
  expect_near(free_joint_velocity(pose, pose, h), Vector6d::Zero(), 0,
              "at rest the velocity is 0", "0 / 0 is not a number");
  const auto tiny = [](double x) { return x < 1e-12 ? "yes" : "no"; };
  std::printf("off qvel before the step by up to   %.3e\n", at_start);
  std::printf("off qvel after it by less than 1e-12:     %s\n", tiny(at_end));
  std::printf("by hand the same, to 1e-12:               %s\n", tiny(by_hand));
}
