// Lesson 5.1: inverse kinematics by damped least squares.
//
// INPUT    pick_place.xml at its keyframe "home"; a place for the hand
// PROCESS  step the arm's joints towards it, plainly and damped; nothing is
//          simulated, only the kinematics computed
// OUTPUT   the way to the cube; then to a place out of reach: how far off the
//          hand ends, and the largest step that a joint was told to make; and
//          what is left there if a radian counts as much as so many metres
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l5_1_reach

#include <algorithm>
#include <cstdio>
#include <mjcourse/arm.hpp>

using namespace mjcourse;
using Eigen::Vector3d, Eigen::Matrix3d;
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Vector7d = Eigen::Matrix<double, 7, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor>;

// #region step
// The error: how far to move, and how far to turn (world frame).
Vector6d error_of(const mjData* data, int site, const Pose& target) {
  double is[4], local[3];
  mju_mat2Quat(is, data->site_xmat + 9 * site);
  const auto& q = target.orientation;
  const double wanted[] = {q.w(), q.x(), q.y(), q.z()};
  mju_subQuat(local, wanted, is);  // a rotation vector, in the hand's frame

  Vector6d error;
  error.head<3>() = target.position - Vector3d(data->site_xpos + 3 * site);
  mju_rotVecQuat(error.data() + 3, local, is);  // now in the world's
  return error;
}

// The step of the seven joints that takes the hand there, nearly.
Vector7d step_to(const mjModel* model, const mjData* data, int site,
                 Vector6d error, double damping, double metres = 1) {
  Jacobian all(6, model->nv);
  mj_jacSite(model, data, all.data(), all.data() + 3 * model->nv, site);
  all.bottomRows<3>() *= metres;  // so many for a radian
  error.tail<3>() *= metres;
  const auto J = all.leftCols<7>();  // of all joints, the arm's
  const Matrix6d damped =
      J * J.transpose() + damping * damping * Matrix6d::Identity();
  return J.transpose() * damped.ldlt().solve(error);
}
// #endregion

struct Way {
  double distance = 0, angle = 0;  // still missing at the end; m, rad
  double largest = 0;              // of all steps of all joints, rad
};

Way reach(const Model& model, const Pose& target, double damping, int steps,
          bool show, double metres = 1) {
  const Data data = make_data(model);
  mj_resetDataKeyframe(model, data, id_of(model, mjOBJ_KEY, "home"));
  const int site = id_of(model, mjOBJ_SITE, "grasp");
  Way way;
  for (int step = 0;; ++step) {
    mj_kinematics(model, data);
    mj_comPos(model, data);  // mj_jacSite needs both
    const Vector6d error = error_of(data, site, target);
    way.distance = error.head<3>().norm();
    way.angle = error.tail<3>().norm();
    if (show)
      std::printf("%4d  %14.6f  %13.6f\n", step, 1000 * way.distance,
                  way.angle);
    if (step == steps) return way;
    const Vector7d dq = step_to(model, data, site, error, damping, metres);
    way.largest = std::max(way.largest, dq.cwiseAbs().maxCoeff());
    qpos(model, data).head<7>() += dq;
  }
}

int main() {
  const Model model = load_model("pick_place");
  const Pose cube{{0.54, -0.06, 0.423}, pointing_down(0.4)};
  std::printf("step  distance (mm)  angle (rad)\n");
  reach(model, cube, 0.02, 5, true);

  const Pose away{{1.2, -0.06, 0.423}, pointing_down(0.4)};
  std::printf("out of reach, 4 steps\n");
  for (const double damping : {0.0, 0.2}) {
    const Way way = reach(model, away, damping, 4, false);
    std::printf("damping %.1f: largest %.1f rad, %.2f m off\n", damping,
                way.largest, way.distance);
    result(damping == 0 ? "plain" : "damped", way.largest);
  }
  std::printf("out of reach, 300 damped steps\n");
  for (const double metres : {1.0, 0.1}) {
    const Way way = reach(model, away, 0.2, 300, false, metres);
    std::printf("a radian is %.1f m: %.3f m and %.3f rad off\n", metres,
                way.distance, way.angle);
    if (metres < 1) result("turned", way.angle * 180 / M_PI);
  }
}
