// Lesson 5.1, exercise: how little is enough?
//
// INPUT    pick_place.xml at its keyframe "hold": the cube between the fingers
// PROCESS  let the pads press little more than they must; then open them by
//          0.2 mm/s, until the cube falls by more than 1 mm/s
// OUTPUT   how hard each pad pressed at that moment, beside m g / 2 mu; for a
//          question, the same for a cube of 120 g and pads of mu = 0.8, under a
//          gravity that is larger by 2 m/s^2, as in a hand that lifts; checks
//          that both agree, and with pads that are smoother than the cube
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l5_1_loosen

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;

// How hard each of the two pads must press (N), so that friction just carries
// the cube. The body's mass is in body_mass, a geom's coefficient of friction
// is the first of its three numbers in geom_friction, opt.gravity is a vector.
double press_needed(const Model& model) {
  const int cube = id_of(model, mjOBJ_BODY, "cube");
  const int side = id_of(model, mjOBJ_GEOM, "cube");
  const int pad = id_of(model, mjOBJ_GEOM, "finger_left_pad");
  // #region answer
  const double weight = model->body_mass[cube] * -model->opt.gravity[2];
  const double friction =
      std::max(model->geom_friction[3 * side], model->geom_friction[3 * pad]);
  return weight / (2 * friction);
  // #starter
  // return model->body_mass[cube];  // the weight? friction? how many pads?
  // #wrong has-one-pad: the cube goes when
  // const double weight = model->body_mass[cube] * -model->opt.gravity[2];
  // return weight / model->geom_friction[3 * pad];
  // #wrong multiplies-by-friction: the cube goes when
  // const double weight = model->body_mass[cube] * -model->opt.gravity[2];
  // return weight * model->geom_friction[3 * pad] / 2;
  // #wrong knows-one-gravity: a heavier cube goes when
  // const double weight = model->body_mass[cube] * 9.81;
  // return weight / (2 * std::max(model->geom_friction[3 * side],
  //                               model->geom_friction[3 * pad]));
  // #wrong asks-the-pads-only: between smooth pads, a rough cube
  // const double weight = model->body_mass[cube] * -model->opt.gravity[2];
  // return weight / (2 * model->geom_friction[3 * pad]);
  // #endregion
}

struct Loosened {
  double needed, went, creep;  // N, N, mm/s
};

Loosened loosen(const Model& model) {
  const Data data = make_data(model);
  mj_resetDataKeyframe(model, data, id_of(model, mjOBJ_KEY, "hold"));
  const int cube = id_of(model, mjOBJ_BODY, "cube");
  const int gripper = id_of(model, mjOBJ_ACTUATOR, "gripper");
  const double* press = data->sensordata;  // of the two pads, N
  const double* falls = data->qvel + model->body_dofadr[cube] + 2;  // m/s
  const double needed = press_needed(Model(mj_copyModel(nullptr, model)));

  // A pad is pushed with kp / 2 for a metre between its command and its place.
  const double kp = model->actuator_gainprm[gripper * mjNGAIN];
  const double first = std::max(0.6, std::min(2.0, 2.1 * needed));  // N
  data->ctrl[gripper] = data->qpos[7] - first / (kp / 2);
  const int two_seconds = std::lround(2 / model->opt.timestep);
  for (int step = 0; step < two_seconds; ++step) mj_step(model, data);
  const double creep = -1000 * *falls;

  for (int step = 0; *falls > -0.001 && step < 12 * two_seconds; ++step) {
    data->ctrl[gripper] += 0.0002 * model->opt.timestep;
    mj_step(model, data);
  }
  return {needed, press[0], creep};
}

bool check(const Loosened& cube, const char* what, const char* meaning) {
  return expect_near(cube.needed, cube.went, 0.01 * std::abs(cube.went), what,
                     meaning);
}

int main() {
  const Model model = load_model("pick_place");
  const Loosened cube = loosen(model);
  std::printf("m g / 2 mu    %.3f N\n", cube.needed);
  std::printf("when it went  %.3f N\n", cube.went);
  result("needed", cube.needed);
  result("went", cube.went);
  result("creep", cube.creep);
  if (!check(cube, "the cube goes when the pads press less than that",
             "two pads carry the weight, each with mu times what it presses; "
             "which mu?"))
    return 0;
  const auto set_friction = [&](const char* geom, double friction) {
    model->geom_friction[3 * id_of(model, mjOBJ_GEOM, geom)] = friction;
  };
  for (const char* pad : {"finger_left_pad", "finger_right_pad"})
    set_friction(pad, 0.8);
  set_friction("cube", 1.1);
  if (!check(loosen(model), "between smooth pads, a rough cube goes no sooner",
             "which of the two coefficients does MuJoCo take?"))
    return 0;
  set_friction("cube", 0.8);
  model->body_mass[id_of(model, mjOBJ_BODY, "cube")] = 0.12;
  model->opt.gravity[2] -= 2;
  const Loosened lifted = loosen(model);
  result("lifted_needed", lifted.needed);
  result("lifted_went", lifted.went);
  check(lifted, "a heavier cube goes when they press less than that",
        "mass, gravity and friction are those of the model");
}
