// Lesson 1.4, challenge: a wanted motion, and the controls that make it.
//
// INPUT    three_arms.xml; a wanted swing of the front arm, for two seconds
// PROCESS  put the wanted pose, velocity and acceleration into a second mjData,
//          ask mj_inverse for the torques, divide by the gears: that is ctrl;
//          apply it with steps of 2 and of 1 ms, then with weak springs and
//          dampers towards the wanted motion
// OUTPUT   the largest error of an angle in each half second; checks what the
//          controls make of the arm at rest, in motion, and with other torques
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_4_follow

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;
using Eigen::Array2d, Eigen::Vector2d;

// The front arm's joints are the last two: tail<2>().
struct Wanted {
  Vector2d q, v, a;
};
Wanted wanted(double t) {
  const Array2d middle(0.5, -1), swing(0.4, 0.6), rate(2, 3);  // rad, rad, 1/s
  return {middle + swing * (1 - (rate * t).cos()),
          swing * rate * (rate * t).sin(),
          swing * rate.square() * (rate * t).cos()};
}

// The controls (-1 to 1) with which the front arm's two motors bring about the
// wanted acceleration, in the wanted pose and at the wanted velocity, and give
// `more` torque (N m) besides. `ideal` is yours: nothing that is in it matters.
Vector2d controls(const Model& model, const Data& ideal, const Wanted& want,
                  const Vector2d& more) {
  const Vector2d gear(model->actuator_gear[0], model->actuator_gear[6]);
  // #region answer
  qpos(model, ideal).tail<2>() = want.q;
  qvel(model, ideal).tail<2>() = want.v;
  qacc(model, ideal).tail<2>() = want.a;
  mj_inverse(model, ideal);
  const Vector2d torque =
      VectorView(ideal->qfrc_inverse, model->nv).tail<2>() + more;
  return torque.cwiseQuotient(gear);
  // #starter
  // // mj_inverse finds torques in `ideal`: what must be there before?
  // return more.cwiseQuotient(gear);
  // #wrong forgets-the-gears: an arm at rest stays
  // qpos(model, ideal).tail<2>() = want.q;
  // qvel(model, ideal).tail<2>() = want.v;
  // qacc(model, ideal).tail<2>() = want.a;
  // mj_inverse(model, ideal);
  // return VectorView(ideal->qfrc_inverse, model->nv).tail<2>() + more;
  // #wrong only-cancels-the-bias: in motion, the arm
  // qpos(model, ideal).tail<2>() = want.q;
  // qvel(model, ideal).tail<2>() = want.v;
  // mj_forward(model, ideal);
  // const Vector2d bias = VectorView(ideal->qfrc_bias, model->nv).tail<2>();
  // return (bias + more).cwiseQuotient(gear);
  // #wrong adds-torques-to-controls: further torques are
  // qpos(model, ideal).tail<2>() = want.q;
  // qvel(model, ideal).tail<2>() = want.v;
  // qacc(model, ideal).tail<2>() = want.a;
  // mj_inverse(model, ideal);
  // const Vector2d all = VectorView(ideal->qfrc_inverse, model->nv).tail<2>();
  // return all.cwiseQuotient(gear) + more;
  // #endregion
}

// The largest error of an angle in each half second.
std::vector<double> errors(const Model& model, double timestep, double spring) {
  model->opt.timestep = timestep;
  const Data data = make_data(model), ideal = make_data(model);
  const int half_second = std::lround(0.5 / timestep);
  std::vector<double> largest(4, 0);
  for (int step = 0; step < 4 * half_second; ++step) {
    const Wanted want = wanted(step * timestep);
    const Vector2d off = want.q - qpos(model, data).tail<2>();
    const Vector2d slow = want.v - qvel(model, data).tail<2>();
    ctrl(model, data) =
        controls(model, ideal, want, spring * (off + 0.1 * slow));
    mj_step(model, data);
    double& so_far = largest[step / half_second];
    so_far = std::max(so_far, off.cwiseAbs().maxCoeff());
  }
  return largest;
}

void report(const char* name, const std::vector<double>& largest) {
  std::printf("%-25s", name);
  for (const double error : largest) std::printf("  %7.5f", error);
  std::puts("");
}

struct Moved {
  Vector2d acceleration, torque;  // of the front arm
};
Moved move(const Model& model, const Wanted& want, const Vector2d& more) {
  const Data data = make_data(model), ideal = make_data(model);
  qpos(model, data).tail<2>() = want.q;
  qvel(model, data).tail<2>() = want.v;
  ctrl(model, data) = controls(model, ideal, want, more);
  mj_forward(model, data);
  return {qacc(model, data).tail<2>(),
          VectorView(data->qfrc_actuator, model->nv).tail<2>()};
}

void check(const Model& model, double t) {
  const Vector2d none(0, 0), more(1, -0.5);
  const Wanted want = wanted(t), rest{want.q, none, none};
  const Moved still = move(model, rest, none), swings = move(model, want, none);
  if (expect_near(still.acceleration, none, 1e-8,
                  "an arm at rest stays at rest",
                  "ctrl is a share of the gear; the front arm's joints are the "
                  "last two; and mj_forward writes over qacc") &&
      expect_near(swings.acceleration, want.a, 1e-8,
                  "in motion, the arm accelerates as it should",
                  "mj_inverse reads qpos, qvel and qacc"))
    expect_near(move(model, want, more).torque - swings.torque, more, 1e-8,
                "further torques are added in N m",
                "a motor multiplies all of its control by its gear");
}

int main() {
  const Model model = load_model("three_arms");
  std::puts("largest error (rad) in     0-0.5 s  0.5-1 s  1-1.5 s  1.5-2 s");
  const std::vector<double> alone = errors(model, 0.002, 0);
  report("mj_inverse, 2 ms", alone);
  report("mj_inverse, 1 ms", errors(model, 0.001, 0));
  const std::vector<double> held = errors(model, 0.002, 10);
  report("and springs, 2 ms", held);
  result("growth", alone[1] / alone[0]);
  result("bought_ms", 500 * std::log(2) / std::log(alone[1] / alone[0]));
  result("held_mrad", 1000 * *std::max_element(held.begin(), held.end()));
  for (const double t : {0.1, 0.8, 1.7}) check(model, t);
}
