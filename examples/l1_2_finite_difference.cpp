// Lesson 1.2, challenge: velocities from a recording of poses.
//
// INPUT    joint_zoo.xml; its free box, thrown so that it tumbles
// PROCESS  record two seconds, finely enough to stand for the true motion;
//          recover the velocity from poses 2 ms and 20 ms apart; compare it
//          with qvel at the start, middle and end of each interval
// OUTPUT   the largest errors, and their ratios; checks that the velocities
//          lead from each pose to the next
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l1_2_finite_difference

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

using namespace mjcourse;
using Eigen::all, Eigen::last, Eigen::seq, Eigen::seqN;
using Eigen::Array3d, Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

// One column for each time: qpos is nq x n, qvel is nv x n.
struct Recording {
  MatrixXd qpos, qvel;
};

// Lets the free box tumble for `duration` seconds and records every step.
Recording record_tumble(const Model& model, double duration) {
  const Data data = make_data(model);
  const int vadr = model->jnt_dofadr[id_of(model, mjOBJ_JOINT, "free")];
  qvel(model, data).segment<6>(vadr) << 0.1, 0, 0, 0.5, 1, 2;

  const Index n = std::lround(duration / model->opt.timestep) + 1;
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
  // #region answer
  MatrixXd v(model->nv, qpos_traj.cols() - 1);
  for (Index k = 0; k < v.cols(); ++k)
    mj_differentiatePos(model, v.col(k).data(), dt, qpos_traj.col(k).data(),
                        qpos_traj.col(k + 1).data());
  return v;
  // #starter
  // // One column for each pair of neighbours.
  // return MatrixXd();
  // #wrong difference-of-the-numbers: there are nv numbers for each pair
  // const Index n = qpos_traj.cols() - 1;
  // return (qpos_traj.rightCols(n) - qpos_traj.leftCols(n)) / dt;
  // #wrong backwards: the box turns in the direction of qvel
  // MatrixXd v(model->nv, qpos_traj.cols() - 1);
  // for (Index k = 0; k < v.cols(); ++k)
  //   mj_differentiatePos(model, v.col(k).data(), dt,
  //                       qpos_traj.col(k + 1).data(),
  //                       qpos_traj.col(k).data());
  // return v;
  // #wrong dt-of-the-recording: in dt, each velocity leads to the next pose
  // MatrixXd v(model->nv, qpos_traj.cols() - 1);
  // for (Index k = 0; k < v.cols(); ++k)
  //   mj_differentiatePos(model, v.col(k).data(), model->opt.timestep,
  //                       qpos_traj.col(k).data(),
  //                       qpos_traj.col(k + 1).data());
  // return v;
  // #endregion
}

// Whether `v` has, for each pair of neighbours, the velocity that leads from
// the one to the other in `dt`. `qvel` has the recorded ones of all `poses`.
bool check(const mjModel* model, const MatrixXd& poses, const MatrixXd& qvel,
           const MatrixXd& v, double dt) {
  const Index n = poses.cols() - 1;
  if (!expect(v.rows() == model->nv && v.cols() == n,
              "there are nv numbers for each pair of neighbours",
              "n poses have n - 1 pairs, and nq is not nv"))
    return false;
  const auto dot = v.cwiseProduct(qvel.leftCols(n)).colwise().sum();
  if (!expect(dot.minCoeff() > 0, "the box turns in the direction of qvel",
              "a difference is the later pose minus the earlier one"))
    return false;
  double apart = 0;
  for (Index k = 0; k < n; ++k) {
    VectorXd q = poses.col(k), rest(model->nv);
    mj_integratePos(model, q.data(), v.col(k).data(), dt);
    mj_differentiatePos(model, rest.data(), 1, q.data(),
                        poses.col(k + 1).data());
    apart = std::max(apart, rest.norm());
  }
  return expect_near(apart, 0, 1e-9,
                     "in dt, each velocity leads to the next pose",
                     "dt is the time between the poses that the function gets");
}

// The largest errors against qvel at the start, middle and end of the intervals
// between every `stride`th pose.
Array3d largest_errors(const Model& model, const Recording& fine, int stride) {
  const MatrixXd poses = fine.qpos(all, seq(0, last, stride));
  const MatrixXd qvel = fine.qvel(all, seq(0, last, stride));
  const double dt = stride * model->opt.timestep;
  const MatrixXd v = finite_difference_velocity(model, poses, dt);
  if (!check(model, poses, qvel, v, dt)) return Array3d::Constant(NAN);
  Array3d errors;
  for (int part = 0; part < 3; ++part) {
    const auto samples = seqN(part * stride / 2, v.cols(), stride);
    errors[part] = (v - fine.qvel(all, samples)).colwise().norm().maxCoeff();
  }
  return errors;
}

int main() {
  const Model model = load_model("joint_zoo");
  model->opt.integrator = mjINT_RK4;  // so that what is measured is the
  model->opt.timestep = 0.0002;       // differencing, not the simulation
  const Recording fine = record_tumble(model, 2);
  const Array3d narrow = largest_errors(model, fine, 10);
  const Array3d wide = largest_errors(model, fine, 100);
  const Array3d ratio = wide / narrow;

  if (!ratio.isFinite().all()) return 0;  // a check says why
  std::puts("largest error of the recovered velocity (rad/s), against qvel");
  std::puts("   h      at the start  in the middle  at the end");
  const char* row = "%5s    %-11.3g   %-11.3g    %.3g\n";
  std::printf(row, " 2 ms", narrow[0], narrow[1], narrow[2]);
  std::printf(row, "20 ms", wide[0], wide[1], wide[2]);
  std::printf(row, "ratio", ratio[0], ratio[1], ratio[2]);
}
