// Lesson 4.1: every continuous model of a quaternion is upside down somewhere.
//
// INPUT    a body that tumbles once around; a thousand random models, each a sum
//          of waves that ends where it began: 500 near the truth, 500 not
// PROCESS  follow the body's true quaternion without a jump; for each model, seek
//          by bisection where its product with the true quaternion is 0, and
//          measure the angle between the two rotations there
// OUTPUT   how many models are upside down, and the smallest of these angles
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l4_1_anywhere

#include <algorithm>
#include <cstdio>
#include <mjcourse/tumble.hpp>
#include <random>

using namespace mjcourse;
using Eigen::Vector3d, Eigen::Vector4d, Eigen::VectorXd;
using Waves = Eigen::Matrix<double, 4, Eigen::Dynamic>;

constexpr double kTurn = 2 * M_PI;

VectorXd features(double s, int waves) {
  VectorXd f = VectorXd::Ones(1 + 2 * waves);
  for (int w = 1; w <= waves; ++w)
    f.segment<2>(2 * w - 1) << std::cos(w * s), std::sin(w * s);
  return f;
}

// The body's quaternion at each degree, each time with the sign of the last.
std::vector<Vector4d> followed() {
  std::vector<Vector4d> path{quaternion(tumble(0))};
  for (int degree = 1; degree <= 360; ++degree) {
    Vector4d q = quaternion(tumble(kTurn * degree / 360));
    if (q.dot(path.back()) < 0) q = -q;
    path.push_back(q);
  }
  return path;
}

// In between, too.
Vector4d truth(const std::vector<Vector4d>& path, double s) {
  const Vector4d q = quaternion(tumble(s));
  const auto near = static_cast<std::size_t>(360 * s / kTurn);
  return q.dot(path[near]) < 0 ? Vector4d(-q) : q;
}

// The waves that fit what mju_mat2Quat makes of each degree.
Waves nearest(int waves) {
  Eigen::MatrixXd seen(360, 1 + 2 * waves), answers(360, 4);
  for (int degree = 0; degree < 360; ++degree) {
    seen.row(degree) = features(kTurn * degree / 360, waves);
    answers.row(degree) = quaternion(tumble(kTurn * degree / 360));
  }
  return seen.householderQr().solve(answers).transpose();
}

double angle(const Vector4d& a, const Vector4d& b) {  // degrees
  Vector3d turn;
  mju_subQuat(turn.data(), a.data(), b.data());
  return turn.norm() * 180 / M_PI;
}

int main() {
  const std::vector<Vector4d> path = followed();
  const bool negative = (path.front() + path.back()).norm() < 1e-9;
  std::printf("after one turn the quaternion is its own negative: %s\n",
              negative ? "yes" : "no");

  std::vector<Waves> fits;  // with up to 16 waves
  for (int waves = 1; waves <= 16; ++waves) fits.push_back(nearest(waves));
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  int upside_down = 0;
  double smallest = 180;
  for (int n = 0; n < 1000; ++n) {
    const int waves = 1 + n % 16;
    Waves weights =
        Waves::NullaryExpr(4, 1 + 2 * waves, [&] { return normal(random); });
    if (n < 500) weights = 0.1 * weights + fits[waves - 1];
    // #region seek
    const auto model = [&](double s) -> Vector4d {
      return weights * features(s, waves);
    };
    const auto product = [&](double s) { return model(s).dot(truth(path, s)); };
    // The product has changed its sign on the way: somewhere it was 0.
    double low = 0, high = kTurn;
    const double sign = product(low);
    if (sign * product(high) >= 0) continue;
    while (high - low > 1e-10) {
      const double s = (low + high) / 2;
      (sign * product(s) > 0 ? low : high) = s;
    }
    const double off = angle(model(low).normalized(), truth(path, low));
    // #endregion
    upside_down += off > 179.999;
    smallest = std::min(smallest, off);
  }
  std::printf("models that are 180 degrees off somewhere: %d of 1000\n",
              upside_down);
  result("upside_down", upside_down);
  result("smallest", smallest);
}
