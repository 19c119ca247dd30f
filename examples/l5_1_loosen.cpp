// Lesson 5.1, exercise: how little is enough?
//
// INPUT    pick_place.xml at its keyframe "hold": the cube between the fingers
// PROCESS  let the pads press little more than they must; then open them by
//          0.2 mm/s, until the cube falls by more than 1 mm/s
// OUTPUT   how hard each pad pressed at that moment, beside m g / 2 mu; for a
//          question, the same for a cube of 120 g and pads of mu = 0.8, under a
//          gravity that is larger by 2 m/s^2, as in a hand that lifts
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l5_1_loosen

#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

struct Loosened {
  double needed, went, creep;  // N, N, mm/s
};

Loosened loosen(const Model& model) {
  const Data data = make_data(model);
  mj_resetDataKeyframe(model, data, id_of(model, mjOBJ_KEY, "hold"));
  const int cube = id_of(model, mjOBJ_BODY, "cube");
  const int gripper = id_of(model, mjOBJ_ACTUATOR, "gripper");
  const int pad = id_of(model, mjOBJ_GEOM, "finger_left_pad");
  const double* press = data->sensordata;  // of the two pads, N
  const double* falls = data->qvel + model->body_dofadr[cube] + 2;  // m/s
  const double weight = model->body_mass[cube] * -model->opt.gravity[2];
  const double needed = weight / (2 * model->geom_friction[3 * pad]);

  // A pad is pushed with kp / 2 for a metre between its command and its place.
  const double kp = model->actuator_gainprm[gripper * mjNGAIN];
  data->ctrl[gripper] = data->qpos[7] - 2.1 * needed / (kp / 2);
  while (data->time < 2) mj_step(model, data);
  const double creep = -1000 * *falls;

  while (*falls > -0.001) {
    data->ctrl[gripper] += 0.0002 * model->opt.timestep;
    mj_step(model, data);
  }
  return {needed, press[0], creep};
}

int main() {
  const Model model = load_model("pick_place");
  const Loosened cube = loosen(model);
  std::printf("m g / 2 mu    %.3f N\n", cube.needed);
  std::printf("when it went  %.3f N\n", cube.went);
  result("needed", cube.needed);
  result("went", cube.went);
  result("creep", cube.creep);

  model->body_mass[id_of(model, mjOBJ_BODY, "cube")] = 0.12;
  for (const char* geom : {"cube", "finger_left_pad", "finger_right_pad"})
    model->geom_friction[3 * id_of(model, mjOBJ_GEOM, geom)] = 0.8;
  model->opt.gravity[2] -= 2;
  const Loosened lifted = loosen(model);
  result("lifted_needed", lifted.needed);
  result("lifted_went", lifted.went);
}
