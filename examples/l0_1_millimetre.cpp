// Lesson 0.1, exercise: the longest step that stays within a millimetre.
//
// INPUT    falling_box.xml
// PROCESS  with t = n h, the box is g t^2 / (2 n) below the parabola: find the
//          smallest n by hand, and try it and the one before
// OUTPUT   both steps, and how far below the box is with each; exits with 1
//          where the prediction fails
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l0_1_millimetre

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

// How far below the parabola the box is after n steps that take t in all.
double below(const Model& model, int n, double t) {
  model->opt.timestep = t / n;
  const Data data = make_data(model);
  const double parabola = data->qpos[0] + model->opt.gravity[2] * t * t / 2;
  for (int i = 0; i < n; ++i) mj_step(model, data);
  return parabola - data->qpos[0];
}

int main() {
  const Model model = load_model("falling_box");
  const double t = 0.5, allowed = 0.001;  // s, m
  const double g = -model->opt.gravity[2];
  const int n = std::ceil(g * t * t / (2 * allowed));

  const double before = below(model, n - 1, t), enough = below(model, n, t);
  std::printf("%d steps of %.5f ms: %.5f mm\n", n - 1, 1000 * t / (n - 1),
              1000 * before);
  std::printf("%d steps of %.5f ms: %.5f mm\n", n, 1000 * t / n, 1000 * enough);
  result("steps", n);
  result("step_ms", 1000 * t / n);
  return before > allowed && enough <= allowed ? 0 : 1;
}
