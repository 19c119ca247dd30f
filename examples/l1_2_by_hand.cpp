// Lesson 1.2, challenge: the velocity of a free joint, by quaternion algebra.
//
// INPUT    joint_zoo.xml; its free box, thrown so that it tumbles
// PROCESS  for each step of MuJoCo's Euler: from the poses before and after it,
//          recover the velocity by mj_differentiatePos and by hand, and compare
//          them with each other and with qvel on both sides of the step
// OUTPUT   the largest differences, or that they are below 1e-12
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

// (p2 - p1) / dt and log(q1^-1 q2) / dt, from the joint's seven numbers at two
// times.
Vector6d free_joint_velocity(const Vector7d& from, const Vector7d& to,
                             double dt) {
  const Quaterniond q1(from[3], from[4], from[5], from[6]);  // w, x, y, z
  const Quaterniond q2(to[3], to[4], to[5], to[6]);
  Quaterniond turn = q1.conjugate() * q2;
  if (turn.w() < 0)
    turn.coeffs() *= -1;  // of q and -q take the short way round
  const double sine = turn.vec().norm();  // of half the angle
  const double angle = 2 * std::atan2(sine, turn.w());
  const double scale = sine > 0 ? angle / sine : 2;  // at rest, its limit
  Vector6d v;
  v.head<3>() = (to.head<3>() - from.head<3>()) / dt;
  v.tail<3>() = turn.vec() * (scale / dt);
  return v;
}

int main() {
  const Model model = load_model("joint_zoo");
  const Data data = make_data(model);
  const int joint = id_of(model, mjOBJ_JOINT, "free");
  const int qadr = model->jnt_qposadr[joint], vadr = model->jnt_dofadr[joint];
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
    const Vector6d hand =
        free_joint_velocity(q1.segment<7>(qadr), q2.segment<7>(qadr), h);
    by_hand = std::max(by_hand, (hand - v.segment<6>(vadr)).norm());
  }
  const auto tiny = [](double x) { return x < 1e-12 ? "yes" : "no"; };
  std::printf("off qvel before the step by up to   %.3e\n", at_start);
  std::printf("off qvel after it by less than 1e-12:     %s\n", tiny(at_end));
  std::printf("by hand the same, to 1e-12:               %s\n", tiny(by_hand));
}
