// The motion that lesson 4.1 writes down in several ways, and the quaternion of
// a rotation matrix.
//
//   const Eigen::Matrix3d R = tumble(0.5);     // rad
//   const Eigen::Vector4d q = quaternion(R);   // w, x, y, z
#pragma once

#include <mjcourse/mjcourse.hpp>

namespace mjcourse {

// Once around a tilted axis as s goes from 0 to 2 pi, nodding on the way.
inline Eigen::Matrix3d tumble(double s) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 0, 2).normalized();
  const Eigen::AngleAxisd nod(0.8 * std::sin(2 * s), Eigen::Vector3d::UnitY());
  return (Eigen::AngleAxisd(s, axis) * nod).toRotationMatrix();
}

// Of the two, the one that mju_mat2Quat picks.
inline Eigen::Vector4d quaternion(const Eigen::Matrix3d& R) {
  const Eigen::Matrix3d rows = R.transpose();  // MuJoCo's go row by row
  Eigen::Vector4d q;
  mju_mat2Quat(q.data(), rows.data());
  return q;
}

}  // namespace mjcourse
