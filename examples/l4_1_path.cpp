// Lesson 4.1: one smooth motion, written down in five ways.
//
// INPUT    a body that tumbles once around, back to where it was
// PROCESS  at each degree of its way, write its rotation as Euler angles, as a
//          rotation vector, as a quaternion, as two columns of its matrix and
//          as the whole of it; find how far each jumps from degree to degree
// OUTPUT   the largest jumps; for the lesson, the numbers as the table "path"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l4_1_path

#include <cmath>
#include <cstdio>
#include <mjcourse/tumble.hpp>

using namespace mjcourse;
using Eigen::Matrix3d, Eigen::MatrixXd;
using Eigen::Vector3d, Eigen::Vector4d, Eigen::VectorXd;

Vector3d euler(const Matrix3d& R) {  // about z, y, x
  return {std::atan2(R(1, 0), R(0, 0)), std::asin(-R(2, 0)),
          std::atan2(R(2, 1), R(2, 2))};
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
  MatrixXd e(3, 361), v(3, 361), q(4, 361), c(6, 361), m(9, 361);
  // #region written
  for (int k = 0; k < 361; ++k) {
    const Matrix3d R = tumble(s[k]);
    e.col(k) = euler(R);
    q.col(k) = quaternion(R);
    v.col(k) = rotation_vector(q.col(k));
    c.col(k) = R.leftCols<2>().reshaped();
    m.col(k) = R.reshaped();
  }
  // #endregion
  const char* names[] = {"euler", "vector", "quaternion", "columns", "matrix"};
  const MatrixXd* written[] = {&e, &v, &q, &c, &m};
  for (int i = 0; i < 5; ++i) {
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
