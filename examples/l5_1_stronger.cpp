// Lesson 5.1, challenge: the starts that friction could not carry, once more.
//
// INPUT    the starts of l5_1_fifty_starts, and its list of those
// PROCESS  try them with a gripper whose servo asks for twice the pull, of which
//          the motor has 30 N to give
// OUTPUT   the weight that friction could carry before and now, and where the
//          object is
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l5_1_stronger

#include <cstdio>
#include <mjcourse/trial.hpp>

using namespace mjcourse;

int main() {
  const Model model = load_model("pick_place");
  const Model strong(mj_copyModel(nullptr, model));
  strong->actuator_gainprm[Arm::kGripper * mjNGAIN] *= 2;      // kp (ctrl - ...
  strong->actuator_biasprm[Arm::kGripper * mjNBIAS + 1] *= 2;  // ... opening)

  std::mt19937 random(1);
  std::vector<Start> starts;
  for (int i = 0; i < 50; ++i) starts.push_back(draw(random));
  int slippery = 0, placed = 0;
  std::printf("start   weight  could carry     now\n");
  for (const int i : {6, 16, 46}) {
    const Outcome before = Trial(starts[i - 1], model).carry(0.6);
    const Outcome now = Trial(starts[i - 1], strong).carry(0.6);
    slippery += before.could < before.weight;
    placed += now.placed;
    std::printf("%4d   %5.2f N   %5.2f N    %5.2f N  %s\n", i, now.weight,
                before.could, now.could,
                now.placed ? "in the tray" : "left behind");
  }
  result("slippery", slippery);
  result("placed", placed);
}
