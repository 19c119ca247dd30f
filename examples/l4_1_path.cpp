// Lesson 4.1: one smooth motion, written down in four ways.
//
// INPUT    a body that tumbles once around, back to where it was
// PROCESS  at each degree of its way, write its rotation as Euler angles, as a
//          rotation vector, as a quaternion and as two columns of its matrix;
//          find how far each jumps from one degree to the next
// OUTPUT   the largest jumps; for the lesson, the numbers as the table "path"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l4_1_path

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;
using Eigen::AngleAxisd, Eigen::Matrix3d, Eigen::MatrixXd;
using Eigen::Vector3d, Eigen::Vector4d, Eigen::VectorXd;

// #region tumble
// Once around a tilted axis as s goes from 0 to 2 pi, nodding on the way.
Matrix3d tumble(double s) {
  const Vector3d axis = Vector3d(1, 0, 2).normalized();
  return (AngleAxisd(s, axis) *
          AngleAxisd(0.8 * std::sin(2 * s), Vector3d::UnitY()))
      .toRotationMatrix();
}
// #endregion

Vector3d euler(const Matrix3d& R) {  // about z, y, x
  return {std::atan2(R(1, 0), R(0, 0)), std::asin(-R(2, 0)),
          std::atan2(R(2, 1), R(2, 2))};
}

Vector4d quaternion(const Matrix3d& R) {
  const Matrix3d rows = R.transpose();  // MuJoCo's matrices go row by row
  Vector4d q;
  mju_mat2Quat(q.data(), rows.data());
  return q;
}

Vector3d rotation_vector(const Vector4d& q) {
  Vector3d v;
  mju_quat2Vel(v.data(), q.data(), 1);
  return v;
}

// The largest step from one column to the next.
double jump(const MatrixXd& x) {
  const Eigen::Index n = x.cols() - 1;
  return (x.rightCols(n) - x.leftCols(n)).colwise().norm().maxCoeff();
}

int main() {
  const VectorXd s = VectorXd::LinSpaced(361, 0, 2 * M_PI);
  MatrixXd e(3, 361), v(3, 361), q(4, 361), c(6, 361);
  for (int k = 0; k < 361; ++k) {
    const Matrix3d R = tumble(s[k]);
    e.col(k) = euler(R);
    q.col(k) = quaternion(R);
    v.col(k) = rotation_vector(q.col(k));
    c.col(k) = R.leftCols<2>().reshaped();
  }
  const char* names[] = {"euler", "vector", "quaternion", "columns"};
  const MatrixXd* written[] = {&e, &v, &q, &c};
  for (int i = 0; i < 4; ++i) {
    std::printf("%-11s %td numbers, largest jump %.3f\n", names[i],
                written[i]->rows(), jump(*written[i]));
    result(names[i], jump(*written[i]));
  }
  const auto row = [](const MatrixXd& x, int i) -> VectorXd {
    return x.row(i);
  };
  table("path", {{"way", s * 180 / M_PI},
                 {"e1", row(e, 0)},
                 {"e2", row(e, 1)},
                 {"e3", row(e, 2)},
                 {"q1", row(q, 0)},
                 {"q2", row(q, 1)},
                 {"q3", row(q, 2)},
                 {"q4", row(q, 3)},
                 {"c1", row(c, 0)},
                 {"c2", row(c, 1)},
                 {"c3", row(c, 2)},
                 {"c4", row(c, 3)},
                 {"c5", row(c, 4)},
                 {"c6", row(c, 5)}});
}
