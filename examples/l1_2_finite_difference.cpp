// Lesson 1.2, challenge: velocities from a recording of poses.
//
// INPUT    joint_zoo.xml; its free box, thrown so that it tumbles
// PROCESS  (1) record two seconds, finely enough to stand for the true motion;
//          (2) recover the velocity from poses 2 ms and 20 ms apart; compare it
//              with qvel at the start, middle and end of each interval;
//          (3) the same with MuJoCo's Euler integrator, a pose every step;
//          (4) do the free joint by hand, as mj_differentiatePos does
// OUTPUT   the largest errors, their ratios, and whether (3) and (4) agree to
//          1e-12
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_2_finite_difference

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;
using Eigen::all, Eigen::last, Eigen::seq, Eigen::seqN;
using Eigen::Index, Eigen::MatrixXd, Eigen::Quaterniond;
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Vector7d = Eigen::Matrix<double, 7, 1>;

// One column for each time: qpos is nq x n, qvel is nv x n.
struct Recording {
  MatrixXd qpos, qvel;
};

// Lets the free box tumble for `duration` seconds and records every step.
Recording record(const Model& model, int integrator, double timestep,
                 double duration) {
  model->opt.integrator = integrator;
  model->opt.timestep = timestep;
  const Data data = make_data(model);
  const int vadr = model->jnt_dofadr[id_of(model, mjOBJ_JOINT, "free")];
  qvel(model, data).segment<6>(vadr) << 0.1, 0, 0, 0.5, 1, 2;

  const Index n = std::lround(duration / timestep) + 1;
  Recording r{MatrixXd(model->nq, n), MatrixXd(model->nv, n)};
  for (Index k = 0; k < n; ++k) {
    r.qpos.col(k) = qpos(model, data);
    r.qvel.col(k) = qvel(model, data);
    mj_step(model, data);
  }
  return r;
}

// The velocities (nv x n-1) that carry each of n configurations (nq x n), `dt`
// seconds apart, to the next.
MatrixXd finite_difference_velocity(const mjModel* model,
                                    const MatrixXd& qpos_traj, double dt) {
  MatrixXd v(model->nv, qpos_traj.cols() - 1);
  for (Index k = 0; k < v.cols(); ++k)
    mj_differentiatePos(model, v.col(k).data(), dt, qpos_traj.col(k).data(),
                        qpos_traj.col(k + 1).data());
  return v;
}

// The same for one free joint by hand: (p2 - p1) / dt and log(q1^-1 q2) / dt,
// from the joint's seven numbers at two times.
Vector6d free_joint_velocity(const Vector7d& from, const Vector7d& to,
                             double dt) {
  const Quaterniond q1(from[3], from[4], from[5], from[6]);  // w, x, y, z
  const Quaterniond q2(to[3], to[4], to[5], to[6]);
  Quaterniond turn = q1.conjugate() * q2;
  if (turn.w() < 0)
    turn.coeffs() *= -1;  // of q and -q take the short way round
  const double sine = turn.vec().norm();  // of half the angle
  const double angle = 2 * std::atan2(sine, turn.w());
  const double scale = sine > 0 ? angle / sine : 2;  // at rest, its limit
  Vector6d v;
  v.head<3>() = (to.head<3>() - from.head<3>()) / dt;
  v.tail<3>() = turn.vec() * (scale / dt);
  return v;
}

// The largest error of v against the recorded qvel: column k of v against
// sample first + k * stride.
double largest_error(const MatrixXd& v, const MatrixXd& qvel, int first,
                     int stride) {
  return (v - qvel(all, seqN(first, v.cols(), stride)))
      .colwise()
      .norm()
      .maxCoeff();
}

// (1) and (2): a fourth-order integrator at 0.2 ms; every 10th pose, then every
// 100th.
void compare_intervals(const Model& model, double duration) {
  const double timestep = 0.0002;
  const Recording fine = record(model, mjINT_RK4, timestep, duration);
  Eigen::Array3d error[2];
  std::printf(
      "largest error of the recovered velocity (rad/s), against qvel\n");
  std::printf("   h      at the start  in the middle  at the end\n");
  for (int i = 0; i < 2; ++i) {
    const int stride = i == 0 ? 10 : 100;
    const double h = stride * timestep;
    const MatrixXd poses = fine.qpos(all, seq(0, last, stride));
    const MatrixXd v = finite_difference_velocity(model, poses, h);
    for (int part = 0; part < 3; ++part)
      error[i][part] = largest_error(v, fine.qvel, part * stride / 2, stride);
    std::printf("  %2.0f ms   %.3e     %.3e      %.3e\n", 1000 * h, error[i][0],
                error[i][1], error[i][2]);
  }
  const Eigen::Array3d ratio = error[1] / error[0];
  std::printf("  ratio   %-9.1f     %-9.1f      %.1f\n", ratio[0], ratio[1],
              ratio[2]);
}

// (3): semi-implicit Euler moves each pose by exactly the velocity it ends the
// step with. (4): the free joint by hand, on the same poses.
void compare_exactly(const Model& model, double duration) {
  const double h = 0.002;
  const Recording euler = record(model, mjINT_EULER, h, duration);
  const MatrixXd v = finite_difference_velocity(model, euler.qpos, h);
  std::printf(
      "Euler, every step of 2 ms: at the start %.3e, at the end below 1e-12: "
      "%s\n",
      largest_error(v, euler.qvel, 0, 1),
      largest_error(v, euler.qvel, 1, 1) < 1e-12 ? "yes" : "no");

  const int joint = id_of(model, mjOBJ_JOINT, "free");
  const int qadr = model->jnt_qposadr[joint], vadr = model->jnt_dofadr[joint];
  double difference = 0;
  for (Index k = 0; k < v.cols(); ++k) {
    const Vector6d by_hand =
        free_joint_velocity(euler.qpos.col(k).segment<7>(qadr),
                            euler.qpos.col(k + 1).segment<7>(qadr), h);
    const Vector6d by_mujoco = v.col(k).segment<6>(vadr);
    difference =
        std::max(difference, (by_hand - by_mujoco).cwiseAbs().maxCoeff());
  }
  std::printf("by hand within 1e-12 of mj_differentiatePos: %s\n",
              difference < 1e-12 ? "yes" : "no");
}

int main() {
  const Model model = load_model("joint_zoo");
  const double duration = 2;  // s
  compare_intervals(model, duration);
  compare_exactly(model, duration);
}
