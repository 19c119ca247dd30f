// Lesson 3.2: the tilt of the box, from a gyro and an accelerometer.
//
// INPUT    imu_lift.xml, recorded with noise and a gyro bias: five minutes at
//          rest, and two in motion
// PROCESS  integrate the gyro; take the accelerometer alone; blend both by a
//          complementary filter, and by a Kalman filter that also seeks the
//          bias
// OUTPUT   errors against the true tilt, and those derived for a box at rest
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_2_tilt

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/imu.hpp>

using namespace mjcourse;
using Eigen::Matrix2d, Eigen::RowVector2d, Eigen::Vector2d;

constexpr double h = 0.002;  // s
constexpr double kDegrees = 180 / M_PI;

// #region complementary
// Follows the gyro, and is drawn towards the accelerometer in tau seconds.
struct Complementary {
  double tau, tilt = 0;
  double update(const ImuSample& imu) {
    const double a = h / (tau + h);
    tilt = (1 - a) * (tilt + h * imu.gyro) + a * imu.acc_tilt();
    return tilt;
  }
};
// #endregion

// #region kalman
// Estimates x = (tilt, bias of the gyro), and P, the covariance of its
// error.
struct Kalman {
  double spread;  // rad: how far the accelerometer's tilt may be off
  Vector2d x = Vector2d::Zero();
  Matrix2d P = Vector2d(0.1, 0.01).asDiagonal();

  double update(const ImuSample& imu) {
    Matrix2d F, Q;
    F << 1, -h, 0, 1;
    Q << std::pow(h * kGyroNoise, 2), 0, 0, h * 1e-8;
    x[0] += h * (imu.gyro - x[1]);  // predict, with the bias removed
    P = F * P * F.transpose() + Q;

    const RowVector2d H(1, 0);  // the accelerometer sees the tilt alone
    const double S = H * P * H.transpose() + spread * spread;
    const Vector2d K = P * H.transpose() / S;
    x += K * (imu.acc_tilt() - H * x);
    P = (Matrix2d::Identity() - K * H) * P;
    return x[0];
  }
};
// #endregion

// Mean and root mean square of the error in degrees, after the first minute.
struct Error {
  double mean, rms;
};
template <typename Estimate>
Error error(const std::vector<ImuSample>& run, Estimate estimate,
            double until = 300) {
  double sum = 0, squares = 0;
  int n = 0;
  for (const ImuSample& imu : run) {
    const double e = kDegrees * (estimate(imu) - imu.tilt);
    if (imu.time < 60 || imu.time > until) continue;
    sum += e, squares += e * e, ++n;
  }
  return {sum / n, std::sqrt(squares / n)};
}

int main() {
  const std::vector<ImuSample> runs[] = {record_imu(1, false, 300),
                                         record_imu(2, true, 120)};
  std::printf("rms error (degrees)      at rest  in motion\n");
  const auto compare = [&](const char* name, const char* key, auto make) {
    double rms[2];
    for (int i = 0; i < 2; ++i) rms[i] = error(runs[i], make(), 120).rms;
    std::printf("%-24s  %6.2f  %9.2f\n", name, rms[0], rms[1]);
    result(std::string(key) + "_rest", rms[0]);
    result(std::string(key) + "_motion", rms[1]);
  };
  compare("gyro alone", "gyro", [] {
    return [tilt = 0.0](const ImuSample& imu) mutable {
      return tilt += h * imu.gyro;
    };
  });
  compare("accelerometer alone", "acc",
          [] { return [](const ImuSample& imu) { return imu.acc_tilt(); }; });
  for (const double tau : {0.1, 0.8, 6.0}) {
    char name[40], key[20];
    std::snprintf(name, sizeof name, "complementary, %.1f s", tau);
    std::snprintf(key, sizeof key, "tau_%.0f", 10 * tau);
    compare(name, key, [=] {
      return [filter = Complementary{tau}](const ImuSample& imu) mutable {
        return filter.update(imu);
      };
    });
  }
  double bias = 0;
  compare("Kalman", "kalman", [&] {
    return [&, filter = Kalman{0.15}](const ImuSample& imu) mutable {
      filter.update(imu);
      bias = filter.x[1];
      return filter.x[0];
    };
  });
  std::printf("bias, true and as found: %.3f and %.3f rad/s\n", kGyroBias,
              bias);
  result("bias", bias);

  // At rest both errors can be derived.
  std::vector<double> taus, mean, mean_derived, spread, spread_derived, motion;
  for (double tau = 0.025; tau < 8; tau *= std::sqrt(2)) {
    const auto filter = [&] {
      return [f = Complementary{tau}](const ImuSample& imu) mutable {
        return f.update(imu);
      };
    };
    const Error rest = error(runs[0], filter());
    const double a = h / (tau + h), g = 9.81;
    const double variance = (std::pow((1 - a) * h * kGyroNoise, 2) +
                             std::pow(a * kAccNoise / g, 2)) /
                            (1 - (1 - a) * (1 - a));
    taus.push_back(tau);
    mean.push_back(rest.mean);
    mean_derived.push_back(kDegrees * tau * kGyroBias);
    spread.push_back(std::sqrt(rest.rms * rest.rms - rest.mean * rest.mean));
    spread_derived.push_back(kDegrees * std::sqrt(variance));
    motion.push_back(error(runs[1], filter()).rms);
  }
  const auto best = std::min_element(motion.begin(), motion.end());
  result("best_tau", taus[best - motion.begin()]);
  result("best_motion", *best);
  table("taus", {{"tau", taus},
                 {"offset", mean},
                 {"offset derived", mean_derived},
                 {"spread", spread},
                 {"spread derived", spread_derived},
                 {"motion", motion}});
}
