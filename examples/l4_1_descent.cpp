// Lesson 4.1, exercise: the same rotation error, walked down by two losses.
//
// INPUT    a target and an estimate 40 degrees beside it, with the other sign
// PROCESS  25 steps of gradient descent on |q - target|^2 / 2, back to unit
//          length after each; 25 on angle^2 / 2, by mju_subQuat and
//          mju_quatIntegrate
// OUTPUT   the angle that is left, step by step; for the lesson, "descent"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l4_1_descent

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;
using Eigen::Vector3d, Eigen::Vector4d;

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

int main() {
  const double degree = M_PI / 180, rate = 0.2;
  const Vector3d axis = Vector3d(1, 2, 2) / 3;
  const Vector4d target(1, 0, 0, 0);
  Vector4d by_norm;
  mju_axisAngle2Quat(by_norm.data(), axis.data(), 40 * degree);
  by_norm *= -1;  // the same rotation
  Vector4d by_angle = by_norm;

  std::vector<double> steps, norm, angle;
  for (int step = 0; step <= 25; ++step) {
    steps.push_back(step);
    norm.push_back(error(by_norm, target).norm() / degree);
    angle.push_back(error(by_angle, target).norm() / degree);
    if (step % 5 == 0)
      std::printf("step %2d  by norm %6.2f  by angle %5.2f degrees off\n", step,
                  norm.back(), angle.back());
    step_by_norm(by_norm, target, rate);
    step_by_angle(by_angle, target, rate);
  }
  result("worst", *std::max_element(norm.begin(), norm.end()));
  table("descent", {{"step", steps}, {"norm", norm}, {"angle", angle}});
}
