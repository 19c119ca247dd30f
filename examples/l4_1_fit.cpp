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

#include <cstdio>
#include <mjcourse/tumble.hpp>

using namespace mjcourse;
using Eigen::Matrix3d, Eigen::MatrixXd, Eigen::Quaterniond, Eigen::VectorXd;

// How a rotation is written, and read back from what was fitted.
struct AsQuaternion {
  static VectorXd write(const Matrix3d& R) { return quaternion(R); }
  static Matrix3d read(const VectorXd& q) {
    return Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
  }
};

struct AsColumns {
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

// The angles between the fitted rotations and the true ones, in degrees.
template <typename Written>
VectorXd fit(int waves) {
  const int samples = 360, tests = 3600;
  const double turn = 2 * M_PI;
  MatrixXd seen(samples, 1 + 2 * waves);
  MatrixXd answers(samples, Written::write(tumble(0)).size());
  for (int k = 0; k < samples; ++k) {
    seen.row(k) = features(turn * k / samples, waves);
    answers.row(k) = Written::write(tumble(turn * k / samples));
  }
  const MatrixXd weights = seen.householderQr().solve(answers).transpose();

  VectorXd off(tests);
  for (int k = 0; k < tests; ++k) {
    const double s = turn * k / tests;
    const Matrix3d fitted = Written::read(weights * features(s, waves));
    const Eigen::AngleAxisd missing(tumble(s).transpose() * fitted);
    off[k] = missing.angle() * 180 / M_PI;
  }
  return off;
}

int main() {
  VectorXd quaternion, columns;
  std::printf("waves   quaternion      two columns\n");
  std::printf("      largest   mean   largest   mean\n");
  for (const int waves : {1, 2, 4, 8, 16}) {
    quaternion = fit<AsQuaternion>(waves);
    columns = fit<AsColumns>(waves);
    std::printf("%3d     %5.1f  %5.1f    %6.3f %6.3f\n", waves,
                quaternion.maxCoeff(), quaternion.mean(), columns.maxCoeff(),
                columns.mean());
  }
  result("quaternion", quaternion.maxCoeff());  // with 16 waves
  result("mean", quaternion.mean());
  result("columns", columns.maxCoeff());
}
