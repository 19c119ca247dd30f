// Lesson 2.3: how fast a ball has to be to be pushed through a thin wall.
//
// INPUT    thin_wall.xml: a ball with a radius of 20 mm, a wall 10 mm thick
// PROCESS  throw the ball from 20 starts within one step of each other; find
//          the speed at which half of the throws get through
// OUTPUT   that speed for several walls, time constants and steps, beside the
//          formula
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_3_wall

#include <array>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <numbers>

using namespace mjcourse;

constexpr double kWay = 0.3;  // m, from the start to the middle of the wall

// #region throw
// At `speed` (m/s), from a start that is nearer by so much (m).
bool gets_through(const Model& model, const Data& data, double speed,
                  double nearer) {
  mj_resetData(model, data);
  data->qpos[0] = nearer;
  data->qvel[0] = speed;
  bool was_in_contact = false;
  while (std::abs(data->qpos[0] - kWay) < 0.35) {
    mj_step(model, data);
    if (was_in_contact && data->ncon == 0) break;  // on one side or the other
    was_in_contact = data->ncon > 0;
  }
  return data->qpos[0] > kWay;
}
// #endregion

// The speed (m/s) at which half of the throws get through.
double limit(const Model& model, const Data& data) {
  const int throws = 20;
  double low = 0.5, high = 40;
  while (high - low > 0.01) {
    const double speed = (low + high) / 2;
    int through = 0;
    for (int i = 0; i < throws; ++i) {
      const double nearer = speed * model->opt.timestep * i / throws;
      through += gets_through(model, data, speed, nearer) ? 1 : 0;
    }
    (2 * through < throws ? low : high) = speed;
  }
  return high;
}

int main() {
  const Model model = load_model("thin_wall");
  const Data data = make_data(model);
  const int wall = id_of(model, mjOBJ_GEOM, "wall");
  const int ball = id_of(model, mjOBJ_GEOM, "ball");
  const double radius = model->geom_size[3 * ball];

  std::printf("wall (mm)  T (ms)  step (ms)  limit (m/s)  formula\n");
  for (const auto& [thickness, time, step] :
       {std::array{0.01, 0.02, 0.002}, std::array{0.01, 0.02, 0.0002},
        std::array{0.04, 0.02, 0.0002}, std::array{0.01, 0.01, 0.0002}}) {
    model->geom_size[3 * wall] = thickness / 2;
    for (const int geom : {wall, ball})
      model->geom_solref[mjNREF * geom] = time;
    model->opt.timestep = step;
    const double found = limit(model, data);
    const double formula = std::numbers::e * (radius + thickness / 2) / time;
    std::printf("%9.0f  %6.0f  %9.1f  %11.2f  %7.2f\n", 1000 * thickness,
                1000 * time, 1000 * step, found, formula);
    if (step == 0.002)
      result("limit", found), result("formula", formula);
    else if (thickness == 0.01 && time == 0.02)
      result("fine", found);
  }
}
