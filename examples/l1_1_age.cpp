// Lesson 1.1: how old the results in mjData are after mj_step.
//
// INPUT    arm_and_crate.xml, its arm told to swing down
// PROCESS  after each step, measure how far the hand's site_xpos is from where
//          qpos puts the hand, and how far the hand moves in one step at its
//          speed, h |J v|
// OUTPUT   the largest of both, in mm; for the lesson, both over time as the
//          table "age"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_1_age

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;
using Eigen::Map, Eigen::Vector3d;
using Jacobian = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>;

int main() {
  const Model model = load_model("arm_and_crate");
  const Data data = make_data(model);
  const Data fresh = make_data(model);  // to look with, so that data stays
  const int hand = id_of(model, mjOBJ_SITE, "hand");
  const double h = model->opt.timestep;
  Jacobian jacobian(3, model->nv);
  ctrl(model, data) << 0.9, 1.2;  // rad, for shoulder and elbow

  std::vector<double> time, behind, moved;
  // #region age
  for (int step = 1; step <= 400; ++step) {
    mj_step(model, data);
    const Map<const Vector3d> read(data->site_xpos + 3 * hand);

    mj_copyData(fresh, model, data);
    mj_kinematics(model, fresh);
    const Map<const Vector3d> true_place(fresh->site_xpos + 3 * hand);

    mj_comPos(model, fresh);  // the Jacobian needs it
    mj_jacSite(model, fresh, jacobian.data(), nullptr, hand);
    const Vector3d velocity = jacobian * qvel(model, fresh);

    time.push_back(data->time);
    behind.push_back(1000 * (true_place - read).norm());  // mm
    moved.push_back(1000 * h * velocity.norm());
  }
  // #endregion

  double gap = 0;
  for (std::size_t k = 0; k < behind.size(); ++k)
    gap = std::max(gap, std::abs(behind[k] - moved[k]));
  const double largest = *std::max_element(behind.begin(), behind.end());
  std::printf("site_xpos is behind by up to     %.2f mm\n", largest);
  std::printf("h |J v| misses it by at most     %.4f mm\n", gap);
  result("largest", largest);
  result("gap", gap);
  table("age", {{"time", time}, {"measured", behind}, {"predicted", moved}});
}
