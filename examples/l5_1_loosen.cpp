// Lesson 5.1, exercise: how little is enough?
//
// INPUT    pick_place.xml at its keyframe "hold": the cube between the fingers
// PROCESS  let the pads press little more than they must; then open them by
//          0.2 mm/s, until the cube falls by more than 1 mm/s
// OUTPUT   how hard each pad pressed at that moment, beside m g / 2 mu
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l5_1_loosen

#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

int main() {
  const Model model = load_model("pick_place");
  const Data data = make_data(model);
  mj_resetDataKeyframe(model, data, id_of(model, mjOBJ_KEY, "hold"));
  const int cube = id_of(model, mjOBJ_BODY, "cube");
  const int gripper = id_of(model, mjOBJ_ACTUATOR, "gripper");
  const int pad = id_of(model, mjOBJ_GEOM, "finger_left_pad");
  const double* press = data->sensordata;  // of the two pads, N
  const double* falls = data->qvel + model->body_dofadr[cube] + 2;  // m/s

  // A pad is pushed with kp / 2 for a metre between its command and its place.
  const double kp = model->actuator_gainprm[gripper * mjNGAIN];
  data->ctrl[gripper] = data->qpos[7] - 0.6 / (kp / 2);
  while (data->time < 2) mj_step(model, data);
  result("creep", -1000 * *falls);  // mm/s

  while (*falls > -0.001) {
    data->ctrl[gripper] += 0.0002 * model->opt.timestep;
    mj_step(model, data);
  }
  const double weight = model->body_mass[cube] * -model->opt.gravity[2];
  const double needed = weight / (2 * model->geom_friction[3 * pad]);
  std::printf("m g / 2 mu    %.3f N\n", needed);
  std::printf("when it went  %.3f N\n", press[0]);
  result("needed", needed);
  result("went", press[0]);
}
