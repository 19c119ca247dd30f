// Lesson 4.1, challenge: can a smooth model learn a rotation?
//
// INPUT    a body that tumbles once around, back to where it was
// PROCESS  fit its quaternion, and two columns of its matrix, by sines and
//          cosines of how far it has gone; make rotations of what was fitted,
//          and measure their angles to the true ones, between the samples too
// OUTPUT   the largest angle and the mean, for more and more waves
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l4_1_fit

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;
using Eigen::AngleAxisd, Eigen::Matrix3d, Eigen::MatrixXd, Eigen::Quaterniond;
using Eigen::Vector3d, Eigen::VectorXd;

Matrix3d tumble(double s) {
  const Vector3d axis = Vector3d(1, 0, 2).normalized();
  return (AngleAxisd(s, axis) *
          AngleAxisd(0.8 * std::sin(2 * s), Vector3d::UnitY()))
      .toRotationMatrix();
}

struct AsQuaternion {
  static constexpr int size = 4;
  static VectorXd write(const Matrix3d& R) {
    const Matrix3d rows = R.transpose();  // MuJoCo's matrices go row by row
    VectorXd q(4);
    mju_mat2Quat(q.data(), rows.data());
    return q;
  }
  static Matrix3d read(const VectorXd& q) {
    return Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
  }
};

struct AsColumns {
  static constexpr int size = 6;
  static VectorXd write(const Matrix3d& R) {
    return R.leftCols<2>().reshaped();
  }
  // #region gram_schmidt
  static Matrix3d read(const VectorXd& c) {
    Matrix3d R;
    R.col(0) = c.head<3>().normalized();
    const double along = R.col(0).dot(c.tail<3>());
    R.col(1) = (c.tail<3>() - along * R.col(0)).normalized();
    R.col(2) = R.col(0).cross(R.col(1));
    return R;
  }
  // #endregion
};

VectorXd features(double s, int waves) {
  VectorXd f = VectorXd::Ones(1 + 2 * waves);
  for (int w = 1; w <= waves; ++w)
    f.segment<2>(2 * w - 1) << std::cos(w * s), std::sin(w * s);
  return f;
}

// Of the angle between the fitted rotation and the true one, in degrees.
struct Error {
  double largest = 0, mean = 0;
};

template <typename Written>
Error fit(int waves) {
  const int samples = 360, tests = 3600;
  MatrixXd weights = MatrixXd::Zero(Written::size, 1 + 2 * waves);
  VectorXd squares = VectorXd::Zero(1 + 2 * waves);
  for (int k = 0; k < samples; ++k) {  // on whole turns waves are orthogonal,
    const double s = 2 * M_PI * k / samples;  // so each is fitted by itself
    const VectorXd f = features(s, waves);
    weights += Written::write(tumble(s)) * f.transpose();
    squares += f.cwiseAbs2();
  }
  weights.array().rowwise() /= squares.transpose().array();
  Error error;
  for (int k = 0; k < tests; ++k) {
    const double s = 2 * M_PI * k / tests;
    const Matrix3d fitted = Written::read(weights * features(s, waves));
    const Matrix3d turn = tumble(s).transpose() * fitted;
    const double angle = AngleAxisd(turn).angle() * 180 / M_PI;
    error.largest = std::max(error.largest, angle);
    error.mean += angle / tests;
  }
  return error;
}

int main() {
  Error quaternion, columns;
  std::printf("waves   quaternion      two columns\n");
  std::printf("      largest   mean   largest   mean\n");
  for (const int waves : {1, 2, 4, 8, 16}) {
    quaternion = fit<AsQuaternion>(waves);
    columns = fit<AsColumns>(waves);
    std::printf("%3d     %5.1f  %5.1f    %6.3f %6.3f\n", waves,
                quaternion.largest, quaternion.mean, columns.largest,
                columns.mean);
  }
  result("quaternion", quaternion.largest);  // with 16 waves
  result("mean", quaternion.mean);
  result("columns", columns.largest);
}
