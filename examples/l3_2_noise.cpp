// Lesson 3.2: MuJoCo's noise, its flag, and whether it repeats.
//
// INPUT    imu_lift.xml, whose sensors state their noise
// PROCESS  collect the gyro's readings at rest: with the flag off and on, after
//          a reset, a seed, another model's compilation, and in two threads
// OUTPUT   standard deviations, and which series are the same to the last bit
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_2_noise

#include <barrier>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <mjcourse/mjcourse.hpp>
#include <thread>

using namespace mjcourse;
using Eigen::VectorXd;

double deviation(const VectorXd& x) {
  return std::sqrt((x.array() - x.mean()).square().mean());
}

// #region series
// What the gyro reads about y, in n steps from a reset.
VectorXd series(const Model& model, const Data& data, int n) {
  mj_resetData(model, data);
  const int gyro = id_of(model, mjOBJ_SENSOR, "gyro");
  VectorXd readings(n);
  for (double& reading : readings) {
    mj_step(model, data);
    reading = data->sensordata[model->sensor_adr[gyro] + 1];
  }
  return readings;
}
// #endregion

int main() {
  const Model model = load_model("imu_lift");
  const Data data = make_data(model);
  const int gyro = id_of(model, mjOBJ_SENSOR, "gyro");
  constexpr int n = 5000;

  std::printf("noise in the model:   %.3f rad/s\n", model->sensor_noise[gyro]);
  const double off = deviation(series(model, data, n));
  model->opt.enableflags |= mjENBL_SENSORNOISE;
  const VectorXd loaded = series(model, data, n);
  const double on = deviation(loaded);
  std::printf("measured, as loaded:  %.3f rad/s\n", off);
  std::printf("with sensornoise:     %.3f rad/s\n", on);
  result("stated", model->sensor_noise[gyro]);
  result("off", off);
  result("on", on);

  // #region repeat
  std::srand(123);
  const VectorXd first = series(model, data, n);
  const auto compare = [&](const char* when, const VectorXd& other) {
    std::printf("%-22s%s\n", when, first == other ? "same bits" : "differ");
  };
  compare("after loading:", loaded);  // the first series with the flag
  compare("after mj_resetData:", series(model, data, n));
  std::srand(123);
  compare("after srand(123):", series(model, data, n));
  const Model other = load_model("flywheel");
  compare("after another model:", series(model, data, n));
  // #endregion

  // #region threads
  VectorXd one, two;
  const Data other_data = make_data(model);
  std::barrier start(2);
  const auto run = [&](const Data& own, VectorXd& readings) {
    start.arrive_and_wait();
    readings = series(model, own, n);
  };
  std::srand(123);
  std::thread thread(run, std::cref(other_data), std::ref(two));
  run(data, one);
  thread.join();
  const bool alone = first == one && first == two;
  std::printf("%-22s%s\n",
              "two threads, both:", alone ? "same bits" : "differ");
  // #endregion
}
