// Lesson 4.1: MuJoCo's rotation helpers, each compared with Eigen.
//
// INPUT    a thousand random pairs of rotations, with a vector each
// PROCESS  compute everything with MuJoCo and with Eigen
// OUTPUT   for each helper, the largest difference
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l4_1_helpers

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <mjcourse/mjcourse.hpp>
#include <random>
#include <string>

using namespace mjcourse;
using Eigen::AngleAxisd, Eigen::Quaterniond;
using Eigen::Vector3d, Eigen::Vector4d, Eigen::VectorXd;
using RowMatrix = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

// MuJoCo's order. Eigen stores x, y, z, w, and is constructed from w, x, y, z.
Vector4d wxyz(const Quaterniond& q) {
  return {q.w(), q.x(), q.y(), q.z()};
}

Quaterniond turn(const Vector3d& v) {  // by |v|, about v
  return Quaterniond(AngleAxisd(v.norm(), v.normalized()));
}
Vector3d rotation_vector(const Quaterniond& q) {
  const AngleAxisd turn(q);
  return turn.angle() * turn.axis();
}

int main() {
  std::mt19937 random(41);
  std::normal_distribution<double> normal;
  const auto vector = [&] {
    return Vector3d(normal(random), normal(random), normal(random));
  };
  std::map<std::string, double> largest;
  const auto compare = [&](const char* name, const VectorXd& mujoco,
                           const VectorXd& eigen) {
    double& difference = largest[name];
    difference = std::max(difference, (mujoco - eigen).norm());
  };

  for (int n = 0; n < 1000; ++n) {
    const Quaterniond a = turn(vector()), b = turn(vector());
    const Vector4d qa = wxyz(a), qb = wxyz(b);
    const Vector3d v = vector(), axis = v.normalized();
    Vector3d r;
    Vector4d q;
    RowMatrix m;
    // #region compare
    mju_mulQuat(q.data(), qa.data(), qb.data());
    compare("mulQuat", q, wxyz(a * b));
    mju_negQuat(q.data(), qa.data());
    compare("negQuat", q, wxyz(a.conjugate()));
    mju_rotVecQuat(r.data(), v.data(), qa.data());
    compare("rotVecQuat", r, a * v);
    mju_axisAngle2Quat(q.data(), axis.data(), 0.7);  // axis of unit length
    compare("axisAngle2Quat", q, wxyz(Quaterniond(AngleAxisd(0.7, axis))));
    mju_quat2Mat(m.data(), qa.data());  // row by row
    compare("quat2Mat", m.reshaped(), a.toRotationMatrix().reshaped());
    mju_mat2Quat(q.data(), m.data());
    compare("mat2Quat", q.dot(qa) < 0 ? Vector4d(-q) : q, qa);  // either sign
    mju_quat2Vel(r.data(), qa.data(), 1);
    compare("quat2Vel", r, rotation_vector(a));
    mju_subQuat(r.data(), qa.data(), qb.data());
    compare("subQuat", r, rotation_vector(b.conjugate() * a));
    q = qa;
    mju_quatIntegrate(q.data(), v.data(), 0.1);  // v along the body's axes
    compare("quatIntegrate", q, wxyz(a * turn(0.1 * v)));
    mju_derivQuat(q.data(), qa.data(), v.data());  // v along the world's axes
    compare("derivQuat", q, 0.5 * wxyz(Quaterniond(0, v[0], v[1], v[2]) * a));
    mju_quatZ2Vec(q.data(), v.data());
    const Vector3d across = Vector3d::UnitZ().cross(v);
    const double angle = std::atan2(across.norm(), v.z());
    compare("quatZ2Vec", q, wxyz(turn(angle * across.normalized())));
    // #endregion
  }
  double worst = 0;
  for (const auto& [name, difference] : largest) {
    std::printf("mju_%-15s %.1e\n", name.c_str(), difference);
    worst = std::max(worst, difference);
  }
  std::printf("all below 1e-14: %s\n", worst < 1e-14 ? "yes" : "no");
}
