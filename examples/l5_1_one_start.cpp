// Lesson 5.1: one of the fifty starts, written out.
//
// INPUT    the sixteenth start of l5_1_fifty_starts.cpp: a ball
// PROCESS  reach for it where the camera sees it; close; wait; say, by the room
//          beside it and by what the pads feel, whether it can be lifted; lift
// OUTPUT   both inequalities, and what became of the ball
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l5_1_one_start

#include <cstdio>
#include <mjcourse/trial.hpp>

using namespace mjcourse;
using Eigen::Vector3d;

int main() {
  const Model model = load_model("pick_place");
  std::mt19937 random(1);
  std::vector<Start> starts;
  for (int i = 0; i < 16; ++i) starts.push_back(draw(random));
  const Start& start = starts.back();
  const Data data = set_up(start, model);

  // #region trial
  const Hold& hold = kHolds[start.which];
  const double* at = data->xpos + 3 * id_of(model, mjOBJ_BODY, hold.object);
  Pose grasp = pose_for(hold, model, data);
  grasp.position.head<2>() += start.camera;  // where the camera sees it

  Arm arm(model, data);
  arm.move(raised(grasp, 0.14), 0.8);
  arm.move(grasp, 0.6);
  arm.grip(0);
  arm.wait(0.6);  // patience

  // Room: the pads stand 41 mm from the middle. The object takes its half width
  // of that, and the camera's error along the fingers more.
  const Vector3d fingers = grasp.orientation * Vector3d::UnitY();
  const double error = std::abs(fingers.head<2>().dot(start.camera));
  const double room = kOpen - hold.half_width - error;

  // Friction: mu times what the two pads feel, against the weight.
  const double* felt = data->sensordata;
  const double could = start.friction * (felt[0] + felt[1]);
  const double weight = start.mass * -model->opt.gravity[2];

  const double rest = at[2];
  arm.move(raised(grasp, 0.16), 0.6);
  // #endregion
  std::printf("room      %4.1f mm > 0:          %s\n", 1000 * room,
              room > 0 ? "yes" : "no");
  std::printf("friction  %.2f N > %.2f N:     %s\n", could, weight,
              could > weight ? "yes" : "no");
  std::printf("the %s is %s\n", hold.object,
              at[2] > rest + 0.02 ? "lifted" : "left behind");
}
