// Lesson 2.5, challenge: two muscles, one angle, and a stiffness of your choice.
//
// INPUT    muscle_arm.xml; an angle, and how stiff the elbow should be there
// PROCESS  find the activations of biceps and triceps; let the arm come to
//          rest, push it, and let it come to rest again
// OUTPUT   the activations, and who contributes which stiffness; checks the
//          angle and the stiffness
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_5_stiffness

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

// What turns the elbow at rest at this angle (rad): muscles and gravity, N m.
double torque(const mjModel* model, mjData* data, double angle,
              const Eigen::Vector2d& act) {
  mj_resetData(model, data);
  data->qpos[0] = angle;
  data->act[0] = act[0];  // biceps
  data->act[1] = act[1];  // triceps
  mj_forward(model, data);
  return data->qfrc_actuator[0] - data->qfrc_bias[0];
}

// That torque, and how fast it grows with the angle (N m/rad).
Eigen::Vector2d torque_and_slope(const mjModel* model, mjData* data,
                                 double angle, const Eigen::Vector2d& act) {
  const double turn = 1e-5;
  const double change = torque(model, data, angle + turn, act) -
                        torque(model, data, angle - turn, act);
  return {torque(model, data, angle, act), change / (2 * turn)};
}

// The activations with which the elbow is in balance at `angle` (rad), and
// resists with `stiffness` (N m/rad) against being moved from there.
Eigen::Vector2d activations(const mjModel* model, mjData* data, double angle,
                            double stiffness) {
  const auto both = [&](double biceps, double triceps) {
    return torque_and_slope(model, data, angle, {biceps, triceps});
  };
  const Eigen::Vector2d relaxed = both(0, 0);
  // #region answer
  // Both are linear in the activations: two equations for two unknowns.
  Eigen::Matrix2d each;
  each.col(0) = both(1, 0) - relaxed;
  each.col(1) = both(0, 1) - relaxed;
  return each.inverse() * (Eigen::Vector2d(0, -stiffness) - relaxed);
  // #starter
  // // The biceps alone keeps the balance, and the elbow is soft.
  // const double biceps = both(1, 0)[0] - relaxed[0];
  // return {-relaxed[0] / biceps, 0 * stiffness};
  // #wrong turns-the-sign-around: both activations
  // Eigen::Matrix2d each;
  // each.col(0) = both(1, 0) - relaxed;
  // each.col(1) = both(0, 1) - relaxed;
  // return each.inverse() * (Eigen::Vector2d(0, stiffness) - relaxed);
  // #wrong forgets-that-gravity-changes: pushed a little
  // Eigen::Matrix2d each;
  // each.col(0) = both(1, 0) - relaxed;
  // each.col(1) = both(0, 1) - relaxed;
  // return each.inverse() * Eigen::Vector2d(-relaxed[0], -stiffness);
  // #wrong forgets-the-load: without a push, it comes to rest
  // Eigen::Matrix2d each;
  // each.col(0) = both(1, 0) - relaxed;
  // each.col(1) = both(0, 1) - relaxed;
  // return each.inverse() * Eigen::Vector2d(0, -stiffness);
  // #wrong counts-the-relaxed-torque-twice: both activations
  // Eigen::Matrix2d each;
  // each.col(0) = both(1, 0);
  // each.col(1) = both(0, 1);
  // return each.inverse() * (Eigen::Vector2d(0, -stiffness) - relaxed);
  // #endregion
}

// Where the elbow comes to rest, pushed with that torque.
double rest(const mjModel* model, const Eigen::Vector2d& act, double from,
            double push) {
  const Data data = make_data(model);
  data->qpos[0] = from;
  for (int i = 0; i < 2; ++i) data->ctrl[i] = data->act[i] = act[i];
  data->qfrc_applied[0] = push;
  while (data->time < 6) mj_step(model, data);
  return data->qpos[0];
}

int main() {
  const Model model = load_model("muscle_arm");
  const Data data = make_data(model);
  const double degree = M_PI / 180;
  std::printf(
      "                    activations      stiffness from (N m/rad)\n");
  std::printf("angle  stiffness  biceps triceps   load  biceps  triceps\n");
  const auto agrees = [&](int angle, double stiffness) {
    const double wanted = angle * degree;
    const Eigen::Vector2d act = activations(model, data, wanted, stiffness);
    const auto slope = [&](double biceps, double triceps) {
      return -torque_and_slope(model, data, wanted, {biceps, triceps})[1];
    };
    const double load = slope(0, 0);  // with what relaxed muscles add
    std::printf("%5d  %9.1f  %6.3f  %6.3f  %5.2f  %6.2f  %7.2f\n", angle,
                stiffness, act[0], act[1], load, slope(act[0], 0) - load,
                slope(0, act[1]) - load);
    const double still = rest(model, act, wanted, 0);
    const double little = 0.02;
    const double measured =
        2 * little /
        (rest(model, act, wanted, little) - rest(model, act, wanted, -little));
    if (!expect(act.minCoeff() >= 0 && act.maxCoeff() <= 1,
                "both activations are between 0 and 1",
                "a muscle cannot push, and not pull with more than all of it"))
      return false;
    if (!expect_near(still / degree, angle, 0.1,
                     "without a push, it comes to rest at its angle",
                     "the torques of both muscles and of gravity have to add "
                     "up to zero"))
      return false;
    return expect_near(measured, stiffness, 0.02 * stiffness,
                       "pushed a little, it is as stiff as wanted",
                       "stiffness is minus the slope of the torque");
  };
  if (!agrees(60, 3)) return 0;
  agrees(60, 5);
  agrees(60, 7);
  agrees(40, 5);
}
