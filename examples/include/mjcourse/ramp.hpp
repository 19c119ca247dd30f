// The bench of lesson 2.2: three numbers that say how a contact behaves,
// measured with the box of ramp.xml.
//
//   const Model model = load_model("ramp");
//   const Found found = measure(model, 40);  // under a load of 40 N
#pragma once

#include <algorithm>
#include <cmath>
#include <mjcourse/mjcourse.hpp>

namespace mjcourse {

struct Found {
  double depth;    // m, of the box at rest
  double kept;     // of its speed, when it falls flat onto the ramp
  double creep;    // m/s, down the slope
  int iterations;  // of the solver, at most
};

// The share of its speed that the box keeps when it meets the ramp flat, at
// 1 m/s. Gravity is off, so it is thrown.
inline double kept(const Model& model) {
  const Eigen::Vector3d gravity(model->opt.gravity);
  mju_zero3(model->opt.gravity);
  const Data data = make_data(model);
  mj_forward(model, data);
  const double* away = data->site_xmat;  // its columns are x, y, z of the ramp
  const Eigen::Vector3d normal(away[2], away[5], away[8]);
  qpos(model, data).head<3>() += 0.001 * normal;
  qvel(model, data).head<3>() = -normal;
  double speed = 0;
  bool touched = false;
  while (data->time < 0.5) {
    mj_step(model, data);
    double force = 0;
    for (int row = 0; row < data->nefc; ++row)
      force = std::max(force, data->efc_force[row]);
    touched = touched || force > 0;
    if (!touched || force > 0) continue;
    speed = std::max(0.0, qvel(model, data).head<3>().dot(normal));
    break;
  }
  mju_copy3(model->opt.gravity, gravity.data());
  return speed;
}

inline Found measure(const Model& model, double load) {
  const Data data = make_data(model);
  data->ctrl[0] = load;  // N, straight down
  Found found{0, kept(model), 0, 0};
  const auto run_until = [&](double time) {
    while (data->time < time) {
      mj_step(model, data);
      found.iterations = std::max(found.iterations, data->solver_iter);
    }
    mj_forward(model, data);
    return data->sensordata[0];  // m, down the slope
  };
  const double before = run_until(1.5);
  found.creep = (run_until(2) - before) / 0.5;
  found.depth = 0.03 - data->sensordata[2];
  return found;
}

}  // namespace mjcourse
