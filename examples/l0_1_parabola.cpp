// Lesson 0.1: how far a simulated fall is below the textbook's parabola.
//
// INPUT    falling_box.xml, with steps of 2, 10 and 20 ms
// PROCESS  let the box fall for 0.5 s; compare every height with the parabola,
//          and with the parabola less g h t / 2
// OUTPUT   the largest of both differences; for the lesson, the way there
//          as the table "below", and the speed of each step as "speeds"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l0_1_parabola

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;

// The rows of the two tables.
struct Below {
  std::vector<double> time, step, mm;
};
struct Speeds {
  std::vector<double> time, simulated, true_speed;
};

// #region compare
void compare(const Model& model, double h, Below& rows) {
  model->opt.timestep = h;
  const Data data = make_data(model);
  const double g = -model->opt.gravity[2], z0 = data->qpos[0];
  double below = 0, off = 0;
  const int every = std::lround(0.02 / h);  // steps from row to row
  for (int n = 0; n <= std::lround(0.5 / h); ++n) {
    if (n > 0) mj_step(model, data);
    const double t = n * h;
    below = z0 - g * t * t / 2 - data->qpos[0];
    off = std::max(off, std::abs(below - g * h * t / 2));
    if (n % every > 0) continue;
    rows.time.push_back(t);
    rows.step.push_back(1000 * h);
    rows.mm.push_back(1000 * below);
  }
  std::printf("step %2.0f ms: %6.3f mm below, g h t / 2 within 1e-12: %s\n",
              1000 * h, 1000 * below, off < 1e-12 ? "yes" : "no");
}
// #endregion

// Six steps of 50 ms: the one speed of each step, at its two ends.
Speeds staircase(const Model& model) {
  Speeds rows;
  const double h = model->opt.timestep = 0.05;
  const double g = -model->opt.gravity[2];
  const Data data = make_data(model);
  for (int n = 0; n < 6; ++n) {
    mj_step(model, data);
    for (const double t : {n * h, (n + 1) * h}) {
      rows.time.push_back(t);
      rows.simulated.push_back(-data->qvel[0]);
      rows.true_speed.push_back(g * t);
    }
  }
  return rows;
}

int main() {
  const Model model = load_model("falling_box");
  Below rows;
  for (const double h : {0.002, 0.01, 0.02}) compare(model, h, rows);
  table("below", {{"time", rows.time}, {"step", rows.step}, {"mm", rows.mm}});

  const Speeds speeds = staircase(model);
  table("speeds", {{"time", speeds.time},
                   {"simulated", speeds.simulated},
                   {"textbook", speeds.true_speed}});
}
