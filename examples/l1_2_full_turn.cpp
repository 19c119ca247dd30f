// Lesson 1.2: once around. The box is back where it was; its quaternion is not.
//
// INPUT    joint_zoo.xml, its free box tilted by 30 degrees
// PROCESS  spin the box about its own z axis for two turns of two seconds, and
//          record its quaternion; compare two poses one turn apart
// OUTPUT   the quaternion, and where the box's white stripe is, after no turn, one
//          and two; for the lesson, the quaternion all the way as the table
//          "turns", and how far apart the two poses are
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_2_full_turn

#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;
using Eigen::VectorXd;

// Compares the pose after one turn with the one before it: number by number,
// and as MuJoCo does.
void compare(const Model& model, const VectorXd& before,
             const VectorXd& after) {
  VectorXd velocity(model->nv);
  mj_differentiatePos(model, velocity.data(), 1, before.data(), after.data());
  result("apart", (after - before).norm());
  result("turned", velocity.norm());  // no other joint has moved
}

int main() {
  const Model model = load_model("joint_zoo");
  const Data data = make_data(model);
  const int joint = id_of(model, mjOBJ_JOINT, "free");
  const int qadr = model->jnt_qposadr[joint] + 3;  // of the quaternion
  const int vadr = model->jnt_dofadr[joint] + 3;   // of the angular velocity

  // #region spin
  const double tilt = M_PI / 6;
  auto quaternion = qpos(model, data).segment<4>(qadr);
  quaternion << std::cos(tilt / 2), std::sin(tilt / 2), 0, 0;
  qvel(model, data)[vadr + 2] = M_PI;  // rad/s: half a turn in a second

  const Eigen::Map<const Eigen::Vector3d> stripe(
      data->geom_xpos + 3 * id_of(model, mjOBJ_GEOM, "free_mark"));

  std::vector<double> turns, w, x, y, z;
  const int turn = std::lround(2 / model->opt.timestep);  // in steps
  for (int step = 0; step <= 2 * turn; ++step) {
    if (step % turn == 0) {
      mj_kinematics(model, data);
      std::printf("turns %d  q = %-33s stripe at %s\n", step / turn,
                  to_text(quaternion).c_str(), to_text(stripe).c_str());
    }
    if (step % 20 == 0) {
      turns.push_back(static_cast<double>(step) / turn);
      w.push_back(quaternion[0]);
      x.push_back(quaternion[1]);
      y.push_back(quaternion[2]);
      z.push_back(quaternion[3]);
    }
    mj_step(model, data);
  }
  // #endregion

  const VectorXd before = qpos(model, data);
  for (int step = 0; step < turn; ++step) mj_step(model, data);
  compare(model, before, qpos(model, data));
  table("turns", {{"turns", turns}, {"w", w}, {"x", x}, {"y", y}, {"z", z}});
}
