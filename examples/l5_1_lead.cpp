// Lesson 5.1: how the arm follows its plan, and why its weight must be up to date.
//
// INPUT    pick_place.xml at its keyframe "home"
// PROCESS  lead the hand to the cube in 0.6 s and wait there: with servos that
//          ignore the weight of the links, that take it from qfrc_bias as the
//          last step left it, and as it is now
// OUTPUT   how far the hand is from its plan, at most and at rest; and whether
//          the last of these is Arm::move, bit by bit. For the lesson, the
//          largest speed and acceleration of the way, and its jerk at the ends,
//          by differences
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l5_1_lead

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <mjcourse/arm.hpp>

using namespace mjcourse;
using Eigen::Vector3d;
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor>;

Pose hand(const mjModel* model, const mjData* data) {
  const int site = id_of(model, mjOBJ_SITE, "grasp");
  double q[4];
  mju_mat2Quat(q, data->site_xmat + 9 * site);
  return {Vector3d(data->site_xpos + 3 * site),
          Eigen::Quaterniond(q[0], q[1], q[2], q[3])};
}

// One damped step of the plan's joints, as in l5_1_reach.cpp.
void reach(const mjModel* model, mjData* plan, const Pose& target) {
  const int site = id_of(model, mjOBJ_SITE, "grasp");
  Jacobian all(6, model->nv);
  mj_jacSite(model, plan, all.data(), all.data() + 3 * model->nv, site);
  const Eigen::Matrix<double, 6, 7> jacobian = all.leftCols<7>();
  const Pose now = hand(model, plan);
  const auto turn = target.orientation * now.orientation.conjugate();
  const double q[] = {turn.w(), turn.x(), turn.y(), turn.z()};
  Vector6d error;
  error.head<3>() = target.position - now.position;
  mju_quat2Vel(error.data() + 3, q, 1);
  const Matrix6d damped =
      jacobian * jacobian.transpose() + 0.02 * 0.02 * Matrix6d::Identity();
  Eigen::Map<Eigen::Matrix<double, 7, 1>>(plan->qpos) +=
      jacobian.transpose() * damped.ldlt().solve(error);
  mj_kinematics(model, plan);
  mj_comPos(model, plan);
}

enum class Weight { kIgnored, kOfLastStep, kOfNow };

// #region loop
// The servos pull with kp (ctrl - angle), so ctrl leads the plan by the torque
// that the weight of the links needs, over kp.
void command(const mjModel* model, mjData* data, const mjData* plan,
             Weight weight) {
  for (int j = 0; j < 7; ++j) {
    const double kp = model->actuator_gainprm[j * mjNGAIN];
    const double torque = weight == Weight::kIgnored ? 0 : data->qfrc_bias[j];
    data->ctrl[j] = plan->qpos[j] + torque / kp;
  }
}

// A time step: the plan moves on, and the arm follows.
void follow(const mjModel* model, mjData* data, mjData* plan,
            const Pose& target, Weight weight) {
  reach(model, plan, target);  // a damped step of the plan, no simulation
  if (weight == Weight::kOfLastStep) command(model, data, plan, weight);
  mj_step1(model, data);  // qfrc_bias is up to date
  if (weight != Weight::kOfLastStep) command(model, data, plan, weight);
  mj_step2(model, data);
}
// #endregion

int main() {
  const Model model = load_model("pick_place");
  const int home = id_of(model, mjOBJ_KEY, "home");
  const Data by_hand = make_data(model), by_arm = make_data(model);
  const Data seen = make_data(model);  // only to see where the hand is
  std::vector<Vector3d> way;           // of the hand, with the old qfrc_bias
  mj_resetDataKeyframe(model, by_arm, home);
  mj_forward(model, by_arm);
  const Pose to = pose_for(kHolds[0], model, by_arm);
  const long steps = std::lround(0.6 / model->opt.timestep);
  bool same = false;
  double apart = 0;  // of these two hands, m

  std::printf("off the plan (mm)           largest  after 0.4 s at rest\n");
  for (const auto& [weight, name, key] :
       {std::tuple{Weight::kIgnored, "weight ignored", "ignored"},
        std::tuple{Weight::kOfLastStep, "qfrc_bias of the last step", "last"},
        std::tuple{Weight::kOfNow, "qfrc_bias of now", "now"}}) {
    mj_resetDataKeyframe(model, by_hand, home);
    mj_forward(model, by_hand);
    const Data plan(mj_copyData(nullptr, model, by_hand));
    const Pose from = hand(model, plan);
    double largest = 0, off = 0;
    for (long step = 1; step <= steps + 200; ++step) {
      const double u = static_cast<double>(step) / static_cast<double>(steps);
      const double s = smooth(std::min(u, 1.0));
      follow(model, by_hand, plan,
             {from.position + s * (to.position - from.position),
              from.orientation.slerp(s, to.orientation)},
             weight);
      if (step == steps && weight == Weight::kOfNow) {
        Arm arm(model, by_arm);
        arm.move(to, 0.6);
        same = std::memcmp(by_hand->qpos, by_arm->qpos, 8 * model->nq) == 0;
      }
      mju_copy(seen->qpos, by_hand->qpos, model->nq);
      mj_kinematics(model, seen);
      const Vector3d at = hand(model, seen).position;
      off = (at - hand(model, plan).position).norm();
      largest = std::max(largest, off);
      if (weight == Weight::kOfLastStep) way.push_back(at);
      if (weight == Weight::kOfNow)
        apart = std::max(apart, (at - way[step - 1]).norm());
    }
    std::printf("%-26s  %7.2f  %7.3f\n", name, 1000 * largest, 1000 * off);
    result(std::string(key) + "_largest", 1000 * largest);
    result(std::string(key) + "_rest", 1000 * off);
  }

  std::printf("the last one is Arm::move, bit by bit: %s\n",
              same ? "yes" : "no");
  result("apart", 1000 * apart);

  // Derivatives of s(u), in d/T, d/T^2 and d/T^3; the jerk at the beginning.
  const double h = 1e-3;
  double speed = 0, acceleration = 0;
  for (double u = h; u < 1 - h / 2; u += h) {
    const double before = smooth(u - h), after = smooth(u + h);
    speed = std::max(speed, (after - before) / (2 * h));
    acceleration =
        std::max(acceleration, (after - 2 * smooth(u) + before) / (h * h));
  }
  const double jerk =
      (smooth(3e-5) - 3 * smooth(2e-5) + 3 * smooth(1e-5)) / 1e-15;
  result("speed", speed);
  result("acceleration", acceleration);
  result("jerk", jerk);
  result("lift_jerk", jerk * 0.16 / std::pow(0.6, 3));  // m/s^3
}
