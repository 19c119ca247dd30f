// Lesson 5.1, challenge: the starts that friction could not carry, once more.
//
// INPUT    the starts of l5_1_fifty_starts, and its list of those
// PROCESS  try them with a gripper whose servo asks for twice the pull, of
//          which the motor has 30 N to give
// OUTPUT   the weight that friction could carry before and now, and where the
//          object is; checks that all are in the tray, and the servo
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l5_1_stronger

#include <cstdio>
#include <mjcourse/trial.hpp>

using namespace mjcourse;

// Lets the gripper use the force that its motor has. The gripper is the
// actuator Arm::kGripper, a position servo, whose ctrl is the wanted opening in
// m. It has mjNGAIN numbers in actuator_gainprm and mjNBIAS in
// actuator_biasprm; its force is gainprm[0] * ctrl + biasprm[0] + biasprm[1] *
// opening, within its actuator_forcerange.
void strengthen(const Model& model) {
  // #region answer
  model->actuator_gainprm[Arm::kGripper * mjNGAIN] *= 2;      // kp (ctrl - ...
  model->actuator_biasprm[Arm::kGripper * mjNBIAS + 1] *= 2;  // ... opening)
  // #starter
  // // More force, and still none at the wanted opening:
  // model->actuator_gainprm[Arm::kGripper * mjNGAIN] *= 1;
  // #wrong forgets-the-bias: at the wanted opening
  // model->actuator_gainprm[Arm::kGripper * mjNGAIN] *= 2;
  // #wrong takes-the-first-bias: at the wanted opening
  // model->actuator_gainprm[Arm::kGripper * mjNGAIN] *= 2;
  // model->actuator_biasprm[Arm::kGripper * mjNBIAS] *= 2;
  // #wrong raises-the-limit: all three objects
  // model->actuator_forcerange[2 * Arm::kGripper] *= 2;
  // model->actuator_forcerange[2 * Arm::kGripper + 1] *= 2;
  // #wrong makes-all-lighter: each object weighs
  // model->opt.gravity[2] = -7;
  // #endregion
}

// The gripper's force (N) where its fingers are as far open as they should be.
double idle_force(const Model& model) {
  const Data data = make_data(model);
  mj_resetDataKeyframe(model, data, id_of(model, mjOBJ_KEY, "home"));  // open
  mj_forward(model, data);
  data->ctrl[Arm::kGripper] = data->actuator_length[Arm::kGripper];
  mj_forward(model, data);
  return data->actuator_force[Arm::kGripper];
}

int main() {
  const Model model = load_model("pick_place");
  const Model strong(mj_copyModel(nullptr, model));
  strengthen(strong);
  if (!expect_near(idle_force(strong), 0, 1e-9,
                   "at the wanted opening, the gripper does not pull",
                   "a servo's gain is in two places"))
    return 0;

  std::mt19937 random(1);
  std::vector<Start> starts;
  for (int i = 0; i < 50; ++i) starts.push_back(draw(random));
  int slippery = 0, placed = 0;
  std::printf("start   weight  could carry     now\n");
  for (const int i : {6, 16, 46}) {
    const Outcome before = Trial(starts[i - 1], model).carry(0.6);
    const Outcome now = Trial(starts[i - 1], strong).carry(0.6);
    if (!expect_near(now.weight, before.weight, 0,
                     "each object weighs what it did",
                     "only the gripper is to change"))
      return 0;
    slippery += before.could < before.weight;
    placed += now.placed;
    std::printf("%4d   %5.2f N   %5.2f N    %5.2f N  %s\n", i, now.weight,
                before.could, now.could,
                now.placed ? "in the tray" : "left behind");
  }
  result("slippery", slippery);
  result("placed", placed);
  expect(placed == 3, "all three objects arrive in the tray",
         "the pads press as little as before, or something else has changed");
}
