// Lesson 4.1, exercise: the same rotation error, walked down by two losses.
//
// INPUT    a target, and an estimate 40 degrees from it
// PROCESS  eight steps of gradient descent on |q - target|^2 / 2, back to unit
//          length after each; and on angle^2 / 2, by mju_subQuat and
//          mju_quatIntegrate; each from q, and from -q
// OUTPUT   the angle that is left, step by step; for the lesson, "descent";
//          checks a step by the norm that does not depend on the sign
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l4_1_descent

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;
using Eigen::ArrayXd, Eigen::Vector3d, Eigen::Vector4d;

// #region steps
// The rotation vector from the target to q, along the target's axes.
Vector3d error(const Vector4d& q, const Vector4d& target) {
  Vector3d turn;
  mju_subQuat(turn.data(), q.data(), target.data());
  return turn;
}

void step_by_angle(Vector4d& q, const Vector4d& target, double rate) {
  const Vector3d gradient = error(q, target);  // of angle^2 / 2
  mju_quatIntegrate(q.data(), gradient.data(), -rate);
}
// #endregion

void step_by_norm(Vector4d& q, const Vector4d& target, double rate) {
  q -= rate * (q - target);
  mju_normalize4(q.data());
}

// The same, but towards the nearer of the target's two names, `target` and
// `-target`. Both quaternions have unit length; so has q afterwards.
void step_to_nearer(Vector4d& q, const Vector4d& target, double rate) {
  // #region answer
  const double sign = q.dot(target) < 0 ? -1 : 1;
  q -= rate * (q - sign * target);
  mju_normalize4(q.data());
  // #starter
  // q -= rate * (q - target);  // towards `target` only
  // mju_normalize4(q.data());
  // #wrong looks-at-w-only: half the gradient is half the angle
  // const double sign = q[0] < 0 ? -1 : 1;
  // q -= rate * (q - sign * target);
  // mju_normalize4(q.data());
  // #wrong turns-the-comparison: half the gradient is half the angle
  // const double sign = q.dot(target) > 0 ? -1 : 1;
  // q -= rate * (q - sign * target);
  // mju_normalize4(q.data());
  // #wrong ignores-the-rate: the whole gradient is the whole angle
  // const double sign = q.dot(target) < 0 ? -1 : 1;
  // q = (q + sign * target).normalized();
  // #wrong by-the-angle: by the norm, a step goes straight
  // step_by_angle(q, target, rate);
  // #wrong forgets-the-length: q has unit length
  // const double sign = q.dot(target) < 0 ? -1 : 1;
  // q -= rate * (q - sign * target);
  // #endregion
}

// Some unit quaternion; another for each n.
Vector4d some(int n) {
  const Vector3d axis =
      Vector3d(std::sin(n), std::cos(3 * n), 0.5).normalized();
  Vector4d q;
  mju_axisAngle2Quat(q.data(), axis.data(), 2 * n);
  return q;
}

void check(int n) {
  const Vector4d target = some(n);
  Vector4d q = some(n + 5);
  if (q.dot(target) < 0) q = -q;
  Vector4d stepped = q, negative = -q;
  step_to_nearer(stepped, target, 0.5);
  step_to_nearer(negative, target, 0.5);
  if (!expect_near(stepped.norm(), 1, 1e-9, "q has unit length after a step",
                   "a sum of two unit quaternions is shorter"))
    return;
  if (!expect_near(error(stepped, target).norm(), error(q, target).norm() / 2,
                   1e-9, "half the gradient is half the angle",
                   "of the target's names it takes the one that is far from q"))
    return;
  expect_near(error(negative, stepped).norm(), 0, 1e-9,
              "from -q it gets to the same pose as from q",
              "-q is nearer to the other name of the target");
  Vector4d whole = q, quarter = q;
  step_to_nearer(whole, target, 1);
  if (!expect_near(error(whole, target).norm(), 0, 1e-6,
                   "the whole gradient is the whole angle",
                   "the rate does not say how far it goes"))
    return;
  step_to_nearer(quarter, target, 0.25);
  expect_near(quarter, (q + 0.25 * (target - q)).normalized(), 1e-9,
              "by the norm, a step goes straight from one to the other",
              "a share of the angle is another step");
}

// The angle to the target, in degrees, before and after each of eight steps.
template <typename Step>
ArrayXd walk(Vector4d q, Step step) {
  const Vector4d target(1, 0, 0, 0);
  ArrayXd left(9);
  for (double& angle : left) {
    angle = error(q, target).norm() * 180 / M_PI;
    step(q, target, 0.5);
  }
  return left;
}

int main() {
  const Vector3d axis = Vector3d(1, 2, 2) / 3;
  Vector4d q;
  mju_axisAngle2Quat(q.data(), axis.data(), 40 * M_PI / 180);
  const ArrayXd norm = walk(-q, step_by_norm), angle = walk(-q, step_by_angle);
  const ArrayXd norm_q = walk(q, step_by_norm),
                angle_q = walk(q, step_by_angle);

  std::printf("         from -q           from q\n");
  std::printf("step    norm   angle     norm   angle\n");
  for (int n = 0; n < norm.size(); ++n)
    std::printf("%4d  %6.2f  %6.2f   %6.2f  %6.2f\n", n, norm[n], angle[n],
                norm_q[n], angle_q[n]);
  result("norm_first", norm[1]);
  result("norm_fifth", norm[5]);
  result("angle_fifth", angle[5]);
  table("descent", {{"step", ArrayXd::LinSpaced(9, 0, 8)},
                    {"norm", norm},
                    {"angle", angle}});
  for (int n = 0; n < 20; ++n) check(n);
}
