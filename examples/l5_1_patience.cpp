// Lesson 5.1: how long must the arm wait before it lifts?
//
// INPUT    pick_place.xml; the hand around the cube, the carton or the ball
// PROCESS  tell the fingers to close; after 0 to 0.4 s, lift by 160 mm. Beside
//          it, say when the fingers touch: the motor pulls each one with kp / 2
//          for a metre, its gears resist with b, so the opening shrinks as
//          exp(-t kp / 2b)
// OUTPUT   when they touch, said and felt; for the lesson, how far each object
//          came up
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l5_1_patience

#include <cstdio>
#include <mjcourse/arm.hpp>

using namespace mjcourse;

// The hand around the object, open.
Pose approach(const Model& model, const Data& data, const Hold& hold) {
  mj_resetDataKeyframe(model, data, id_of(model, mjOBJ_KEY, "home"));
  mj_forward(model, data);
  const Pose grasp = pose_for(hold, model, data);
  Arm arm(model, data);
  arm.move(raised(grasp, 0.14), 1);
  arm.move(grasp, 1);
  arm.wait(0.2);
  return grasp;
}

int main() {
  const Model model = load_model("pick_place");
  const double kp = model->actuator_gainprm[Arm::kGripper * mjNGAIN];
  const int slide = id_of(model, mjOBJ_JOINT, "finger_left");
  const double b = model->dof_damping[model->jnt_dofadr[slide]];
  const double tau = b / (kp / 2);  // s

  std::vector<double> patience, risen[3];
  for (int i = 0; i <= 20; ++i) patience.push_back(0.02 * i);
  std::printf("        touch, said  felt\n");
  for (int k = 0; k < 3; ++k) {
    const Hold& hold = kHolds[k];
    const int body = id_of(model, mjOBJ_BODY, hold.object);
    const Data ready = make_data(model);
    const Pose grasp = approach(model, ready, hold);
    for (const double seconds : patience) {
      const Data data(mj_copyData(nullptr, model, ready));
      Arm arm(model, data);
      arm.grip(0);
      arm.wait(seconds);
      arm.move(raised(grasp, 0.16), 0.3);
      arm.wait(0.3);
      risen[k].push_back(
          1000 * (data->xpos[3 * body + 2] - ready->xpos[3 * body + 2]));
    }
    // And once more without any lift, to feel for the touch.
    double touch = 0;
    Arm arm(model, ready);
    const double start = ready->time;
    arm.watch = [&] {
      if (touch == 0 && ready->sensordata[0] > 0) touch = ready->time - start;
    };
    arm.grip(0);
    arm.wait(0.6);
    // A pad is 1 mm further from the middle than its slide says.
    const double said = tau * std::log(0.04 / (hold.half_width - 0.001));
    std::printf("%-6s     %.3f s   %.3f s\n", hold.object, said, touch);
    result(std::string(hold.object) + "_said", said);
    result(std::string(hold.object) + "_felt", touch);
  }
  result("tau", tau);
  table("lifts", {{"patience", patience},
                  {"cube", risen[0]},
                  {"carton", risen[1]},
                  {"ball", risen[2]}});
}
