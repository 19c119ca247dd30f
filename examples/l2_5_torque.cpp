// Lesson 2.5: one activation, and the torque that it makes elsewhere.
//
// INPUT    muscle_arm.xml, the biceps fully active
// PROCESS  put the elbow to angles from 0 to 140 degrees, at rest, bending at
//          2 rad/s and straightening at 2 rad/s; compute the biceps' torque
//          from its length and its velocity, step by step
// OUTPUT   the steps and the torque; whether MuJoCo has the same; for the
//          lesson, the table "torque"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_5_torque

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <string>
#include <vector>

using namespace mjcourse;

// #region chain
struct Chain {
  double active, passive, force, torque;
};

// What muscle i does to the joint of degree of freedom `dof`.
Chain chain(const mjModel* model, const mjData* data, int i, int dof) {
  const double* parameters = model->actuator_gainprm + mjNGAIN * i;
  const double* range = model->actuator_lengthrange + 2 * i;
  const double length = data->actuator_length[i];
  const double velocity = data->actuator_velocity[i];
  const double acc0 = model->actuator_acc0[i];
  const double act = data->act[i];  // the first muscle has the first one

  Chain found;
  found.active =
      act * mju_muscleGain(length, velocity, range, acc0, parameters);
  found.passive = mju_muscleBias(length, range, acc0, parameters);
  found.force = found.active + found.passive;
  found.torque = data->actuator_moment[i * model->nv + dof] * found.force;
  return found;
}
// #endregion

int main() {
  const Model model = load_model("muscle_arm");
  const Data data = make_data(model);
  double apart = 0;
  const auto biceps = [&](int angle, double speed) {
    data->qpos[0] = angle * M_PI / 180;
    data->qvel[0] = speed;
    data->act[0] = 1;
    mj_forward(model, data);
    const Chain found = chain(model, data, 0, 0);
    const double both = found.torque + chain(model, data, 1, 0).torque;
    apart = std::max({apart, std::abs(found.force - data->actuator_force[0]),
                      std::abs(both - data->qfrc_actuator[0])});
    return found;
  };

  std::printf("elbow  speed  length  velocity  active passive   arm torque\n");
  std::printf("(deg) (rad/s)   (mm)    (mm/s)     (N)     (N)  (mm)  (N m)\n");
  std::vector<double> angles, still, bending, straightening, motor;
  const double strongest = biceps(60, 0).torque;
  for (int angle = 0; angle <= 140; angle += 4) {
    angles.push_back(angle);
    motor.push_back(strongest);
    for (const double speed : {0.0, 2.0, -2.0}) {
      const Chain found = biceps(angle, speed);
      (speed == 0  ? still
       : speed > 0 ? bending
                   : straightening)
          .push_back(found.torque);
      if (angle % 40 != 20 || (angle != 60 && speed != 0)) continue;
      std::printf("%5d  %5.0f  %6.1f  %8.1f  %6.1f  %6.1f %5.1f %6.2f\n", angle,
                  speed, 1000 * data->actuator_length[0],
                  1000 * data->actuator_velocity[0] + 0., found.active,
                  found.passive + 0., 1000 * data->actuator_moment[0],
                  found.torque);
      const char* how = speed == 0 ? "still_" : speed > 0 ? "bend_" : "give_";
      result(how + std::to_string(angle), found.torque);
    }
  }
  std::printf("MuJoCo's forces and torques are the same: %s\n",
              apart < 1e-9 ? "yes" : "no");
  result("fraction", std::lround(biceps(60, 0).torque / biceps(140, 0).torque));
  result("speeds", biceps(60, -2).torque / biceps(60, 2).torque);
  table("torque", {{"angle", angles},
                   {"still", still},
                   {"bending", bending},
                   {"straightening", straightening},
                   {"motor", motor}});
}
