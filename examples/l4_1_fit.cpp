// Lesson 4.1, challenge: can a smooth model learn a rotation?
//
// INPUT    a body that tumbles once around, back to where it was
// PROCESS  fit its quaternion, and two columns of its matrix, by sines and
//          cosines of how far it has gone; make rotations of what was fitted,
//          and measure their angles to the true ones, between the samples too
// OUTPUT   the largest angle and the mean, for more and more waves; checks the
//          fit by waves that are known
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

// A constant, and the cosine and sine of 1 to `waves` waves a turn.
VectorXd features(double s, int waves) {
  VectorXd f = VectorXd::Ones(1 + 2 * waves);
  for (int w = 1; w <= waves; ++w)
    f.segment<2>(2 * w - 1) << std::cos(w * s), std::sin(w * s);
  return f;
}

// Each column of `samples` has a number at evenly spaced places of one turn:
// row k at s = 2 pi k / samples.rows(). Returns the sum of features that fits
// it by least squares, at as many `places`: row k at s = 2 pi k / places.
MatrixXd fitted(const MatrixXd& samples, int waves, int places) {
  // #region answer
  const int n = samples.rows();
  MatrixXd seen(n, 1 + 2 * waves), wanted(places, 1 + 2 * waves);
  for (int k = 0; k < n; ++k) seen.row(k) = features(2 * M_PI * k / n, waves);
  for (int k = 0; k < places; ++k)
    wanted.row(k) = features(2 * M_PI * k / places, waves);
  const MatrixXd weights = seen.householderQr().solve(samples);
  return wanted * weights;
  // #starter
  // return samples.row(0).replicate(places, 1);  // fits the first place only
  // #wrong takes-means-of-products: a constant is fitted
  // const int n = samples.rows();
  // MatrixXd seen(n, 1 + 2 * waves), wanted(places, 1 + 2 * waves);
  // for (int k = 0; k < n; ++k)
  //   seen.row(k) = features(2 * M_PI * k / n, waves);
  // for (int k = 0; k < places; ++k)
  //   wanted.row(k) = features(2 * M_PI * k / places, waves);
  // return wanted * seen.transpose() * samples * 2 / n;
  // #wrong repeats-the-samples: between the samples
  // MatrixXd nearest(places, samples.cols());
  // for (int k = 0; k < places; ++k)
  //   nearest.row(k) = samples.row(k * samples.rows() / places);
  // return nearest;
  // #wrong keeps-the-places-of-the-samples: between the samples
  // const int n = samples.rows();
  // MatrixXd seen(n, 1 + 2 * waves), wanted(places, 1 + 2 * waves);
  // for (int k = 0; k < n; ++k)
  //   seen.row(k) = features(2 * M_PI * k / n, waves);
  // for (int k = 0; k < places; ++k)
  //   wanted.row(k) = features(2 * M_PI * k / n, waves);
  // return wanted * seen.householderQr().solve(samples);
  // #endregion
}

// The angles between the fitted rotations and the true ones, in degrees.
template <typename Written>
VectorXd fit(int waves) {
  const int samples = 360, tests = 3600;
  const double turn = 2 * M_PI;
  MatrixXd answers(samples, Written::write(tumble(0)).size());
  for (int k = 0; k < samples; ++k)
    answers.row(k) = Written::write(tumble(turn * k / samples));
  MatrixXd numbers = fitted(answers, waves, tests);
  if (numbers.rows() != tests || numbers.cols() != answers.cols())
    numbers.setZero(tests, answers.cols());

  VectorXd off(tests);
  for (int k = 0; k < tests; ++k) {
    const Matrix3d R = Written::read(numbers.row(k).transpose());
    const Eigen::AngleAxisd missing(tumble(turn * k / tests).transpose() * R);
    off[k] = missing.angle() * 180 / M_PI;
  }
  return off;
}

// Sums of features at n places: a column for each of `weights`.
MatrixXd sums(const MatrixXd& weights, int n) {
  MatrixXd values(n, weights.cols());
  for (int k = 0; k < n; ++k) {
    const VectorXd f = features(2 * M_PI * k / n, weights.rows() / 2);
    for (int c = 0; c < weights.cols(); ++c)
      values(k, c) = f.dot(weights.col(c));
  }
  return values;
}

void check() {
  MatrixXd level = MatrixXd::Zero(5, 2), waves(7, 2);
  level.row(0) << 1, 2;
  for (int k = 0; k < waves.size(); ++k) waves(k) = 1 + 0.2 * k;
  const auto right = [](const MatrixXd& weights, int places) -> VectorXd {
    return sums(weights, places).reshaped();
  };
  const auto fit = [](const MatrixXd& weights, int places) -> VectorXd {
    return fitted(sums(weights, 30), weights.rows() / 2, places).reshaped();
  };
  if (expect_near(
          fit(level, 30), right(level, 30), 1e-9,
          "a constant is fitted exactly",
          "the features are not equally long, or a column is missing") &&
      expect_near(fit(waves, 30), right(waves, 30), 1e-9,
                  "waves are fitted exactly, up to the last one",
                  "a part of the features is missing, or the samples are at "
                  "other places"))
    expect_near(fit(waves, 90), right(waves, 90), 1e-9,
                "between the samples, the fit is right, too",
                "at its places, the result has the sum of the features");
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
  check();
}
