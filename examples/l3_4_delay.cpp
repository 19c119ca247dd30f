// Lesson 3.4, challenge: a control that arrives late.
//
// INPUT    balancing_leg.xml with steps of 10 ms; a torque about y that arrives
//          a number of steps after it was computed
// PROCESS  LQR for the leg as it is, and for the leg with the torques that are
//          under way in its state; let both balance it from 1 degree
// OUTPUT   for each delay, the largest eigenvalue of both, and how far the leg
//          leans in its sixth second; checks the model with the delay
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_4_delay

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <deque>
#include <mjcourse/lqr.hpp>
#include <string>

using namespace mjcourse;
using Eigen::EigenSolver, Eigen::Index, Eigen::MatrixXd, Eigen::Vector2d,
    Eigen::Vector3d, Eigen::VectorXd;

// The same step, whose control arrives `delay` steps late. Its state is that of
// `step`, then the controls that are under way: the one that arrives in the
// next step first, the latest last.
Linear delayed(const Linear& step, int delay) {
  // #region answer
  const Index n = step.A.rows(), nu = step.B.cols(), late = delay * nu;
  if (delay == 0) return step;
  Linear all{MatrixXd::Zero(n + late, n + late), MatrixXd::Zero(n + late, nu)};
  all.A.topLeftCorner(n, n) = step.A;
  all.A.block(0, n, n, nu) = step.B;  // the oldest acts
  for (Index i = 0; i < late - nu; ++i) all.A(n + i, n + nu + i) = 1;
  all.B.bottomRows(nu).setIdentity();  // the new one queues up
  return all;
  // #starter
  // return step;  // as if every control arrived at once
  // #wrong queue-stands-still: the leg and its queue
  // const Index n = step.A.rows(), nu = step.B.cols(), late = delay * nu;
  // if (delay == 0) return step;
  // Linear all{MatrixXd::Zero(n + late, n + late),
  //            MatrixXd::Zero(n + late, nu)};
  // all.A.topLeftCorner(n, n) = step.A;
  // all.A.block(0, n, n, nu) = step.B;
  // all.A.bottomRightCorner(late, late).setIdentity();
  // all.B.bottomRows(nu).setIdentity();
  // return all;
  // #wrong newest-acts: the leg and its queue
  // const Index n = step.A.rows(), nu = step.B.cols(), late = delay * nu;
  // if (delay == 0) return step;
  // Linear all{MatrixXd::Zero(n + late, n + late),
  //            MatrixXd::Zero(n + late, nu)};
  // all.A.topLeftCorner(n, n) = step.A;
  // all.A.block(0, n + late - nu, n, nu) = step.B;
  // for (Index i = 0; i < late - nu; ++i) all.A(n + i, n + nu + i) = 1;
  // all.B.bottomRows(nu).setIdentity();
  // return all;
  // #wrong acts-at-once-as-well: the leg and its queue
  // const Index n = step.A.rows(), nu = step.B.cols(), late = delay * nu;
  // if (delay == 0) return step;
  // Linear all{MatrixXd::Zero(n + late, n + late),
  //            MatrixXd::Zero(n + late, nu)};
  // all.A.topLeftCorner(n, n) = step.A;
  // all.A.block(0, n, n, nu) = step.B;
  // for (Index i = 0; i < late - nu; ++i) all.A(n + i, n + nu + i) = 1;
  // all.B.topRows(n) = step.B;
  // all.B.bottomRows(nu).setIdentity();
  // return all;
  // #wrong one-number-for-each-step: it has room for each control
  // const Index n = step.A.rows(), nu = step.B.cols(), late = delay;
  // if (delay == 0) return step;
  // Linear all{MatrixXd::Zero(n + late, n + late),
  //            MatrixXd::Zero(n + late, nu)};
  // all.A.topLeftCorner(n, n) = step.A;
  // all.A.block(0, n, n, 1) = step.B.col(0);
  // for (Index i = 0; i < late - 1; ++i) all.A(n + i, n + 1 + i) = 1;
  // all.B.row(n + late - 1).setOnes();
  // return all;
  // #wrong forgets-that-there-may-be-none: it has room for each control
  // const Index n = step.A.rows(), nu = step.B.cols();
  // const Index late = (delay + 1) * nu;
  // Linear all{MatrixXd::Zero(n + late, n + late),
  //            MatrixXd::Zero(n + late, nu)};
  // all.A.topLeftCorner(n, n) = step.A;
  // all.A.block(0, n, n, nu) = step.B;
  // for (Index i = 0; i < late - nu; ++i) all.A(n + i, n + nu + i) = 1;
  // all.B.bottomRows(nu).setIdentity();
  // return all;
  // #endregion
}

// Room for the queue, and the same states as a queue that is simulated by hand.
bool check(const Linear& step, int delay) {
  const Linear late = delayed(step, delay);
  const Index n = step.A.rows(), nu = step.B.cols(), all = n + delay * nu;
  if (!expect(late.A.rows() == all && late.A.cols() == all &&
                  late.B.rows() == all && late.B.cols() == nu,
              "it has room for each control that is under way",
              "each step of delay holds nu numbers, and none holds none"))
    return false;
  std::deque<VectorXd> queue(delay, VectorXd::Zero(nu));
  VectorXd x = VectorXd::Ones(n), y = VectorXd::Zero(all);
  y.head(n) = x;
  for (int k = 0; k < 3 * delay + 3; ++k) {
    const VectorXd u = VectorXd::LinSpaced(nu, 1, 2) * std::sin(k + 1);
    queue.push_back(u);
    x = step.A * x + step.B * queue.front();
    queue.pop_front();
    y = late.A * y + late.B * u;
  }
  return expect_near(y.head(n), x, 1e-9 * x.norm(),
                     "the leg and its queue move as they do by hand",
                     "the oldest control acts, the others move up, and the "
                     "new one takes the last place");
}

double largest(const MatrixXd& A) {
  return EigenSolver<MatrixXd>(A).eigenvalues().cwiseAbs().maxCoeff();
}

// The farthest that the leg leans in the last of six seconds, in degrees.
double balance(const Model& model, const MatrixXd& K, int delay) {
  const Data data = make_data(model);
  const Vector3d y(0, 1, 0);
  mju_axisAngle2Quat(data->qpos, y.data(), M_PI / 180);
  std::deque<double> queue(delay, 0);
  double farthest = 0;
  while (data->time < 6) {
    VectorXd dx = VectorXd::Zero(K.cols());
    Vector3d lean;
    mj_differentiatePos(model, lean.data(), 1, model->qpos0, data->qpos);
    dx.head<2>() << lean[1], data->qvel[1];
    for (Index i = 2; i < dx.size(); ++i) dx[i] = queue[i - 2];
    queue.push_back(-(K * dx)[0]);
    data->ctrl[1] = queue.front();
    queue.pop_front();
    mj_step(model, data);
    if (data->time > 5) farthest = std::max(farthest, std::abs(lean[1]));
  }
  return farthest * 180 / M_PI;
}

std::string lean(double degrees) {
  char text[20];
  std::snprintf(text, sizeof text, "%.2f", degrees);
  return degrees > 60 ? "falls" : text;
}

int main() {
  const Model model = load_model("balancing_leg");
  model->opt.timestep = 0.01;
  const Data upright = make_data(model);
  const Linear whole = linearise(model, upright);
  if (!check(whole, 1) || !check(whole, 3) || !check(whole, 0)) return 0;

  Linear plane{MatrixXd(2, 2), MatrixXd(2, 1)};  // about y alone
  plane.A << whole.A(1, 1), whole.A(1, 4), whole.A(4, 1), whole.A(4, 4);
  plane.B << whole.B(1, 1), whole.B(4, 1);
  const MatrixXd R = MatrixXd::Identity(1, 1);
  std::printf("           eigenvalue       leans by (degrees)\n");
  std::printf("delay   plain   queued      plain   queued\n");
  for (const int delay : {0, 10, 15, 20, 30}) {
    const Linear late = delayed(plane, delay);
    MatrixXd Q = MatrixXd::Zero(late.A.rows(), late.A.rows());
    Q(0, 0) = 1;
    MatrixXd simple = MatrixXd::Zero(1, late.A.rows());
    simple.leftCols<2>() = lqr(plane, Q.topLeftCorner<2, 2>(), R);
    const MatrixXd K = lqr(late, Q, R);
    std::printf("%3d ms  %.3f    %.3f  %9s  %7s\n", 10 * delay,
                largest(late.A - late.B * simple), largest(late.A - late.B * K),
                lean(balance(model, simple, delay)).c_str(),
                lean(balance(model, K, delay)).c_str());
  }
}
