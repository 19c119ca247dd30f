// Lesson 5.1: pick up the cube, put it into the tray, and watch the friction.
//
// INPUT    pick_place.xml at its keyframe "home"
// PROCESS  approach, close, wait, lift, carry, lower, open, leave; at each step
//          add up the contact forces between the fingers and the cube
// OUTPUT   at the end of each phase: how hard the pads press, what friction
//          lifts, and the share of its cone that the worst contact uses
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l5_1_pick_and_place

#include <algorithm>
#include <cstdio>
#include <mjcourse/arm.hpp>
#include <mjcourse/grasp.hpp>

using namespace mjcourse;

int main() {
  const Model model = load_model("pick_place");
  const Data data = make_data(model);
  mj_resetDataKeyframe(model, data, id_of(model, mjOBJ_KEY, "home"));
  mj_forward(model, data);
  const int cube = id_of(model, mjOBJ_GEOM, "cube");
  const double* at = data->geom_xpos + 3 * cube;

  Arm arm(model, data);
  std::vector<double> time, lifts, could;
  arm.watch = [&] {  // every 10 ms while something may be held
    const long step = std::lround(data->time / model->opt.timestep);
    if (data->time < 2.2 || data->time > 6.2 || step % 5 != 0) return;
    const Grasp grasp = grasp_of(model, data, cube);
    time.push_back(data->time);
    lifts.push_back(grasp.lifts);
    could.push_back(grasp.could);
  };
  const auto report = [&](const char* phase) {
    const Grasp grasp = grasp_of(model, data, cube);
    std::printf("%-7s  %4.1f  %8.3f  %8.3f  %9.2f  %9.2f  %7.3f\n", phase,
                data->time, arm.hand().position[2], at[2], grasp.press,
                std::max(grasp.lifts, 0.0), grasp.share);
    snapshot(phase, model, data);
    return grasp;
  };

  // #region phases
  std::printf(
      "phase    time  hand (m)  cube (m)  press (N)  lifts (N)  share\n");
  const Pose cube_pose = pose_for(kHolds[0], model, data);
  const Pose tray{{0.62, 0.28, 0.435}, pointing_down(0)};

  arm.move(raised(cube_pose, 0.12), 1.2);
  report("above");
  arm.move(cube_pose, 1.0);
  report("around");
  arm.grip(0);
  arm.wait(0.6);  // patience
  report("closed");
  arm.move(raised(cube_pose, 0.15), 0.8);
  arm.wait(0.5);
  const Grasp held = report("held");
  arm.move(raised(tray, 0.15), 1.2);
  report("carried");
  arm.move(tray, 0.8);
  arm.grip(0.04);
  arm.wait(0.4);
  report("opened");
  arm.move(raised(tray, 0.15), 0.8);
  report("left");
  // #endregion

  const double weight = model->body_mass[id_of(model, mjOBJ_BODY, "cube")] *
                        -model->opt.gravity[2];
  result("weight", weight);
  result("press", held.press / 2);  // of one pad
  result("lifts", held.lifts);
  result("could", held.could);
  result("margin", held.could / weight);
  table("forces", {{"time", time}, {"could carry", could}, {"carries", lifts}});
}
