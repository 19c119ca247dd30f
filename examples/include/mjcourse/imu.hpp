// What the programs of lesson 3.2 share: noise with a seed, and a recorded
// run of the IMU in imu_lift.xml.
//
//   Gaussian gauss(7);              // a seed
//   const double x = 0.2 * gauss(); // standard deviation 0.2
//   const ImuRun run = record_imu(7, true, 20);
#pragma once

#include <cmath>
#include <mjcourse/mjcourse.hpp>
#include <random>
#include <vector>

namespace mjcourse {

// Numbers with mean 0 and standard deviation 1, by Box and Muller. Each
// object has its own generator, so a seed gives the same numbers, whatever
// others draw.
class Gaussian {
 public:
  explicit Gaussian(unsigned long seed) : bits_(seed) {}
  double operator()() {
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(2 * M_PI * uniform());
  }

 private:
  double uniform() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  std::mt19937_64 bits_;
};

// The faults of a cheap IMU.
constexpr double kGyroBias = 0.05;   // rad/s
constexpr double kGyroNoise = 0.02;  // rad/s, of each sample
constexpr double kAccNoise = 0.2;    // m/s^2, of each sample

// One instant of a run: the true tilt (rad), and what the IMU says of it.
struct ImuSample {
  double time, tilt;
  double gyro;          // rad/s, about y
  double acc_x, acc_z;  // m/s^2
  double acc_tilt() const { return std::atan2(-acc_x, acc_z); }
};

// The box stands still, or is tilted to and fro while the lift moves.
inline std::vector<ImuSample> record_imu(unsigned long seed, bool moving,
                                         double seconds) {
  const Model model = load_model("imu_lift");
  const Data data = make_data(model);
  const mjtNum* acc =
      data->sensordata +
      model->sensor_adr[id_of(model, mjOBJ_SENSOR, "accelerometer")];
  const mjtNum* gyro =
      data->sensordata + model->sensor_adr[id_of(model, mjOBJ_SENSOR, "gyro")];
  const int tilt = model->jnt_qposadr[id_of(model, mjOBJ_JOINT, "tilt")];
  Gaussian gauss(seed);
  std::vector<ImuSample> run;
  while (data->time < seconds) {
    const double t = data->time;
    if (moving) {
      data->ctrl[0] = 0.2 * std::sin(2 * M_PI * 0.7 * t);
      data->ctrl[1] = 0.5 * std::sin(2 * M_PI * 0.4 * t) +
                      0.2 * std::sin(2 * M_PI * 1.1 * t);
    }
    const double now = data->qpos[tilt];  // the sensors are about this instant
    mj_step(model, data);
    run.push_back({t, now, gyro[1] + kGyroBias + kGyroNoise * gauss(),
                   acc[0] + kAccNoise * gauss(), acc[2] + kAccNoise * gauss()});
  }
  return run;
}

}  // namespace mjcourse
