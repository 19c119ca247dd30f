// Lesson 3.2: what an accelerometer reads.
//
// INPUT    imu_lift.xml: a box with an accelerometer, on a lift
// PROCESS  rest, tilt, rise, let go; compare the reading with R^T (a - g),
//          where a is a second difference of the places of the box
// OUTPUT   readings; for the lesson, the fall as the table "fall", with the
//          deflection of the ball on springs
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_2_specific_force

#include <algorithm>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;
using Eigen::Matrix3d, Eigen::Vector3d;

struct Sample {
  double time;
  Vector3d place, reading, ball;
  Matrix3d box;  // its axes, as columns
};

// One step; what was true at its start, and what the sensor says of that.
Sample step(const Model& model, const Data& data) {
  const int imu = id_of(model, mjOBJ_SITE, "imu");
  const int acc = id_of(model, mjOBJ_SENSOR, "accelerometer");
  const double t = data->time;
  const Vector3d ball(data->qpos[2], 0, data->qpos[3]);
  mj_step(model, data);
  return {t, Vector3d(data->site_xpos + 3 * imu),
          Vector3d(data->sensordata + model->sensor_adr[acc]), ball,
          Matrix3d(data->site_xmat + 9 * imu).transpose()};
}

int main() {
  const Model model = load_model("imu_lift");
  const Data data = make_data(model);
  const Vector3d g(model->opt.gravity);
  const double h = model->opt.timestep, w = 20;  // rad/s, of the springs

  // #region drive
  std::vector<Sample> samples;
  const auto drive = [&](double until, double lift, double tilt, bool held) {
    model->actuator_forcerange[0] = held ? -40 : 0;
    model->actuator_forcerange[1] = held ? 40 : 0;
    while (data->time < until - h / 2) {
      data->ctrl[0] += 0.02 * (lift - data->ctrl[0]);  // m, with a lag
      data->ctrl[1] += 0.02 * (tilt - data->ctrl[1]);  // rad
      samples.push_back(step(model, data));
    }
    print("", samples.back().reading);
  };
  std::printf("accelerometer (m/s^2), in its own frame\n");
  std::printf("at rest        "), drive(0.5, 0, 0, true);
  std::printf("let go, 0.2 s  "), drive(0.7, 0, 0, false);
  std::printf("held up, 1 s   "), drive(1.7, -0.2, 0, true);
  std::printf("tilting, 0.1 s "), drive(1.8, -0.2, 0.6, true);
  std::printf("tilted         "), drive(3.0, -0.2, 0.6, true);
  // #endregion

  // #region compare
  double most = 0;
  std::vector<double> time, reading, formula, ball;
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    const Sample& now = samples[i];
    const Vector3d step = samples[i + 1].place - now.place;
    const Vector3d before = now.place - samples[i - 1].place;
    const Vector3d a = (step - before) / (h * h);
    const Vector3d derived = now.box.transpose() * (a - g);
    most = std::max(most, (derived - now.reading).norm());
    // #endregion
    if (now.time < 0.4 || now.time > 1.4 || i % 5 != 0) continue;
    time.push_back(now.time);
    reading.push_back(now.reading[2]);
    formula.push_back(derived[2]);
    ball.push_back(-w * w * now.ball[2]);
  }
  std::printf("R^T (a - g) misses it by at most %.2f m/s^2\n", most);
  result("most", most);
  table("fall", {{"time", time},
                 {"reading", reading},
                 {"formula", formula},
                 {"ball", ball}});
}
