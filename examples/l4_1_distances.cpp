// Lesson 4.1: how far apart are two rotations? Four answers.
//
// INPUT    four pairs of rotations, as Euler angles z, y, x in degrees
// PROCESS  for each pair, the norm of the difference of the Euler angles, of the
//          quaternions and of the matrices; and the angle between the rotations
// OUTPUT   the four answers
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l4_1_distances

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <string>

using namespace mjcourse;
using Eigen::Vector3d, Eigen::Vector4d;
using Vector9d = Eigen::Matrix<double, 9, 1>;

constexpr double kDegree = M_PI / 180;

// As nested rings: the outer turns about z, the one in it about its own y, the
// innermost about its own x. Each multiplies from the right.
Vector4d from_euler(const Vector3d& degrees) {
  Vector4d q(1, 0, 0, 0);
  for (int ring = 0; ring < 3; ++ring) {
    const Vector3d axis = Vector3d::Unit(2 - ring);
    Vector4d turn;
    mju_axisAngle2Quat(turn.data(), axis.data(), degrees[ring] * kDegree);
    const Vector4d before = q;
    mju_mulQuat(q.data(), before.data(), turn.data());
  }
  return q;
}

Vector9d matrix(const Vector4d& q) {
  Vector9d m;
  mju_quat2Mat(m.data(), q.data());
  return m;
}

// #region angle
// The angle of the one turn that takes `from` to `to`: 0 to 180 degrees.
double angle(const Vector4d& from, const Vector4d& to) {
  Vector3d turn;  // a rotation vector, axis times angle
  mju_subQuat(turn.data(), to.data(), from.data());
  return turn.norm() / kDegree;
}
// #endregion

int main() {
  struct Pair {
    const char *name, *text;
    Vector3d a, b;
  };
  const Pair pairs[] = {
      {"around", "full turn", {0, 0, 0}, {360, 0, 0}},
      {"half", "half turn", {0, 0, 0}, {180, 0, 0}},
      {"south", "near south", {179, 0, 0}, {-179, 0, 0}},
      {"lock", "nose up", {0, -90, 0}, {60, -90, -60}},
  };
  std::printf("norm of      Euler   quat. matrix  angle\n");
  for (const auto& [name, text, a, b] : pairs) {
    const Vector4d qa = from_euler(a), qb = from_euler(b);
    const double euler = (b - a).norm(), quaternion = (qb - qa).norm();
    std::printf("%-11s  %5.1f   %5.3f  %5.3f  %5.1f\n", text, euler, quaternion,
                (matrix(qb) - matrix(qa)).norm(), angle(qa, qb));
    result(name + std::string("_euler"), euler);
    result(name + std::string("_quaternion"), quaternion);
    result(name + std::string("_angle"), angle(qa, qb));
  }
}
