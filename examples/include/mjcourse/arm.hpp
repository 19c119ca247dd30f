// What the programs of lesson 5.1 share: the arm of pick_place.xml, told where
// its hand should go instead of what each joint should do.
//
//   Arm arm(model, data);
//   arm.move({above_the_cube, pointing_down(yaw)}, 1.5);  // m, rad, s
//   arm.grip(0);   // the fingers set out
//   arm.wait(0.6);  // and get there
//
// A second mjData, the plan, is where the arm ought to be. Inverse kinematics
// moves the plan, as in l5_1_reach.cpp, and the servos follow it. Simulating is
// what `move` and `wait` do; both return when their time is over.
#pragma once

#include <functional>
#include <mjcourse/mjcourse.hpp>

namespace mjcourse {

// Where the point between the fingers is, and how the hand is turned (world).
struct Pose {
  Eigen::Vector3d position;
  Eigen::Quaterniond orientation;
};

// The hand points straight down; at yaw 0 its fingers open along y.
inline Eigen::Quaterniond pointing_down(double yaw) {
  return Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
         Eigen::Quaterniond(0, 0, 1, 0);
}

inline Pose raised(Pose pose, double height) {
  pose.position[2] += height;
  return pose;
}

// How the hand takes hold of an object that stands upright: so far above its
// centre (m), with the fingers turned so far from its own y axis (rad), across
// so much of it to either side (m). The carton is taken across its narrow side,
// high enough that the palm stays clear of its top.
struct Hold {
  const char* object;
  double above, turn, half_width;
};
inline constexpr Hold kHolds[] = {{"cube", 0, 0, 0.023},
                                  {"carton", 0.015, M_PI / 2, 0.024},
                                  {"ball", 0, 0, 0.032}};
inline constexpr double kOpen = 0.041;  // from a pad to the middle, m

// Where the hand must be for that, as things stand. Of the two ways round, the
// fingers being alike, the shorter one.
inline Pose pose_for(const Hold& hold, const mjModel* model,
                     const mjData* data) {
  const int body = id_of(model, mjOBJ_BODY, hold.object);
  const mjtNum* axis = data->xmat + 9 * body;  // its first column: the x axis
  const double yaw = std::atan2(axis[3], axis[0]);
  const Pose pose{Eigen::Vector3d(data->xpos + 3 * body),
                  pointing_down(std::remainder(yaw + hold.turn, M_PI))};
  return raised(pose, hold.above);
}

// From 0 to 1 as u does; speed and acceleration are 0 at both ends.
inline double smooth(double u) {
  return u * u * u * (10 + u * (6 * u - 15));
}

class Arm {
 public:
  static constexpr int kJoints = 7;   // the first of qpos, qvel and ctrl
  static constexpr int kGripper = 7;  // of ctrl

  // Begins where `data` has the arm; both arguments must outlive it.
  Arm(const mjModel* model, mjData* data)
      : model_(model),
        data_(data),
        plan_(make_data(model)),
        site_(id_of(model, mjOBJ_SITE, "grasp")) {
    mju_copy(plan_->qpos, data->qpos, model->nq);
    place_plan();
  }

  // Goes on with `data`, a copy of the other's.
  Arm(const Arm& other, mjData* data)
      : model_(other.model_),
        data_(data),
        plan_(mj_copyData(nullptr, model_, other.plan_)),
        site_(other.site_) {}

  // Called after each step.
  std::function<void()> watch = [] {};

  // Where the hand is: that of the simulation, as of the last step.
  Pose hand() const { return hand_of(data_); }

  // Takes the hand along a straight line in so many seconds, turning evenly.
  void move(const Pose& to, double seconds) {
    const Pose from = hand_of(plan_);
    simulate(seconds, [&](double u) {
      const double s = smooth(u);
      lead_to({from.position + s * (to.position - from.position),
               from.orientation.slerp(s, to.orientation)});
    });
  }

  // Tells each finger to go to `opening` (m). Nothing moves before the next
  // wait or move.
  void grip(double opening) { data_->ctrl[kGripper] = opening; }

  void wait(double seconds) {
    simulate(seconds, [](double) {});
  }

 private:
  Pose hand_of(const mjData* data) const {
    double q[4];
    mju_mat2Quat(q, data->site_xmat + 9 * site_);
    return {Eigen::Vector3d(data->site_xpos + 3 * site_),
            Eigen::Quaterniond(q[0], q[1], q[2], q[3])};
  }

  void place_plan() {
    mj_kinematics(model_, plan_);
    mj_comPos(model_, plan_);  // what mj_jacSite needs besides
  }

  // One damped least-squares step of the plan towards `target`.
  void lead_to(const Pose& target) {
    using Matrix6d = Eigen::Matrix<double, 6, 6>;
    Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor> all(6,
                                                                  model_->nv);
    mj_jacSite(model_, plan_, all.data(), all.data() + 3 * model_->nv, site_);
    const Eigen::Matrix<double, 6, kJoints> jacobian = all.leftCols<kJoints>();

    const Pose now = hand_of(plan_);
    const auto turn = target.orientation * now.orientation.conjugate();
    const double q[] = {turn.w(), turn.x(), turn.y(), turn.z()};
    Eigen::Matrix<double, 6, 1> error;
    error.head<3>() = target.position - now.position;
    mju_quat2Vel(error.data() + 3, q, 1);

    const Matrix6d damped = jacobian * jacobian.transpose() +
                            kDamping * kDamping * Matrix6d::Identity();
    Eigen::Map<Eigen::Matrix<double, kJoints, 1>>(plan_->qpos) +=
        jacobian.transpose() * damped.ldlt().solve(error);
    place_plan();
  }

  // `lead` gets the share of the time that is over, up to 1.
  template <typename Lead>
  void simulate(double seconds, const Lead& lead) {
    const long steps = std::lround(seconds / model_->opt.timestep);
    for (long step = 1; step <= steps; ++step) {
      lead(static_cast<double>(step) / steps);
      mj_step1(model_, data_);  // what the weight asks for now
      // A servo pulls with kp (ctrl - angle), so it must lead the angle by what
      // the weight of the links asks for.
      for (int j = 0; j < kJoints; ++j) {
        const double kp = model_->actuator_gainprm[j * mjNGAIN];
        data_->ctrl[j] = plan_->qpos[j] + data_->qfrc_bias[j] / kp;
      }
      mj_step2(model_, data_);
      watch();
    }
  }

  static constexpr double kDamping = 0.02;
  const mjModel* model_;
  mjData* data_;
  Data plan_;
  int site_;
};

}  // namespace mjcourse
