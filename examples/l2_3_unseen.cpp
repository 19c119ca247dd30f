// Lesson 2.3: how often a step misses a wall altogether.
//
// INPUT    thin_wall.xml: a ball with a radius of 20 mm, a wall 10 mm thick
// PROCESS  throw the ball at 1 to 100 m/s, each time from 100 starts within one
//          step of each other, and count the throws in which no step found a
//          contact
// OUTPUT   their share for some speeds, beside the formula, and what MuJoCo
//          warned of; for the lesson, the shares as the table "shares"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_3_unseen

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;

// #region seen
// At `speed` (m/s), from a start that is nearer by so much (m).
bool is_seen(const Model& model, const Data& data, double speed,
             double nearer) {
  mj_resetData(model, data);
  data->qpos[0] = nearer;
  data->qvel[0] = speed;
  while (data->qpos[0] < 0.4) {
    mj_step(model, data);
    if (data->ncon > 0) return true;
  }
  return false;
}
// #endregion

int main() {
  const Model model = load_model("thin_wall");
  const Data data = make_data(model);
  const int wall = id_of(model, mjOBJ_GEOM, "wall");
  const int ball = id_of(model, mjOBJ_GEOM, "ball");
  const double seen_in =
      2 * (model->geom_size[3 * wall] + model->geom_size[3 * ball]);  // m

  const int starts = 100;
  int warnings = 0;
  std::vector<double> speeds, unseen, expected;
  for (int i = 0; i <= 40; ++i) {
    const double speed = std::pow(10, i / 20.0);
    const double way = speed * model->opt.timestep;  // m, in one step
    int missed = 0;
    for (int start = 0; start < starts; ++start) {
      missed += is_seen(model, data, speed, way * start / starts) ? 0 : 1;
      for (const mjWarningStat& warning : data->warning)
        warnings += warning.number;
    }
    speeds.push_back(speed);
    unseen.push_back(missed / double(starts));
    expected.push_back(std::max(0.0, 1 - seen_in / way));
  }
  table("shares",
        {{"speed", speeds}, {"unseen", unseen}, {"expected", expected}});

  std::printf("m/s    unseen  formula\n");
  for (const std::size_t i : {20U, 30U, 34U, 40U})
    std::printf("%5.1f  %6.2f  %7.2f\n", speeds[i], unseen[i], expected[i]);
  std::printf("warnings: %d\n", warnings);
  result("first", seen_in / model->opt.timestep);  // m/s
  result("last", unseen.back());
}
