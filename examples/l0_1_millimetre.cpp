// Lesson 0.1, exercise: the longest step that stays within a millimetre.
//
// INPUT    falling_box.xml
// PROCESS  with t = n h, the box is g t^2 / (2 n) below the parabola: find the
//          smallest n by hand, and try it and the one before
// OUTPUT   both steps, and how far below the box is with each; checks the same
//          for other times and distances
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

// The smallest number of equal steps that take t in all and leave the box at
// most `allowed` below the parabola; g is positive. SI units.
int steps_needed(double allowed, double t, double g) {
  // #region answer
  return std::ceil(g * t * t / (2 * allowed));
  // #starter
  // return 0;  // the box is g h t / 2 below, and there are t / h steps
  // #wrong forgets-the-half: one step fewer is too few
  // return std::ceil(g * t * t / allowed);
  // #wrong rounds-down: the box stays within what is allowed
  // return g * t * t / (2 * allowed);
  // #endregion
}

void check(const Model& model, double allowed, double t, double g) {
  const int n = steps_needed(allowed, t, g);
  const std::string here =
      "for " + to_text(1000 * allowed) + " mm in " + to_text(t) + " s, ";
  if (!expect(n > 0, "the number of steps is positive",
              "it is a number of steps, and not how long one of them takes"))
    return;
  const bool is_enough = expect(
      below(model, n, t) <= allowed, "the box stays within what is allowed",
      here + "these steps are too long, even if only by a little");
  if (is_enough && n > 1)
    expect(
        below(model, n - 1, t) > allowed, "one step fewer is too few",
        here + "longer steps would do: there are more of them than necessary");
}

int main() {
  const Model model = load_model("falling_box");
  const double t = 0.5, allowed = 0.001;  // s, m
  const double g = -model->opt.gravity[2];
  const int n = steps_needed(allowed, t, g);

  const double before = below(model, n - 1, t), enough = below(model, n, t);
  std::printf("%d steps of %.5f ms: %.5f mm\n", n - 1, 1000 * t / (n - 1),
              1000 * before);
  std::printf("%d steps of %.5f ms: %.5f mm\n", n, 1000 * t / n, 1000 * enough);
  result("steps", n);
  result("step_ms", 1000 * t / n);

  check(model, allowed, t, g);
  check(model, 0.01, 0.3, g);
  check(model, 0.002, 0.4, g);
}
