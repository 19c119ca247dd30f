// Lesson 3.4: a drone that LQR brings back, and what it needs to know for that.
//
// INPUT    drone.xml at its keyframe "hover": a free joint, and four thrusts
//          that follow their controls with 50 ms
// PROCESS  linearise a step; solve for the gain; start tilted, for four
//          seconds; again without the thrusts in the state, and with a gain
//          for rotors that follow at once
// OUTPUT   sizes; how far off the drone is at the end; for the lesson, the
//          table "flights" and the snapshots "start" and "later"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_4_hover

#include <cmath>
#include <cstdio>
#include <mjcourse/lqr.hpp>
#include <string>
#include <vector>

using namespace mjcourse;
using Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

// #region error
// The change from one state to another: 2 nv + na numbers.
VectorXd change(const mjModel* model, const mjData* from, const mjData* to) {
  const int nv = model->nv, na = model->na;
  VectorXd dx(2 * nv + na);
  mj_differentiatePos(model, dx.data(), 1, from->qpos, to->qpos);
  mju_sub(dx.data() + nv, to->qvel, from->qvel, nv);
  mju_sub(dx.data() + 2 * nv, to->act, from->act, na);
  return dx;
}
// #endregion

// #region design
MatrixXd design(const Model& model, const Data& hover) {
  const Linear step = linearise(model, hover);
  const long n = step.A.rows();
  MatrixXd Q = MatrixXd::Zero(n, n);
  Q.diagonal().head(model->nv).fill(1);  // a metre costs like a radian
  const MatrixXd R = 0.001 * MatrixXd::Identity(model->nu, model->nu);
  return lqr(step, Q, R);
}
// #endregion

struct Flight {
  bool lands = false;              // on the floor, which ends it
  std::vector<double> time, tilt;  // s, degrees
  double off = 0;                  // m, at its end
};

Flight fly(const Model& model, const Data& hover, const MatrixXd& K,
           double degrees, bool show) {
  const Data data = make_data(model);
  mj_copyData(data, model, hover);
  const Vector3d axis(0.6, 0.8, 0);
  mju_axisAngle2Quat(data->qpos + 3, axis.data(), degrees * M_PI / 180);
  Flight flight;
  for (int step = 0; step <= 2000; ++step) {
    if (show && step == 0) snapshot("start", model, data);
    if (show && step == 150) snapshot("later", model, data);
    const VectorXd dx = change(model, hover, data);
    flight.off = dx.head<3>().norm();
    flight.lands = data->ncon > 0;
    if (step % 10 == 0 || flight.lands) {
      flight.time.push_back(data->time);
      flight.tilt.push_back(dx.segment<3>(3).norm() * 180 / M_PI);
    }
    if (flight.lands) break;
    // #region control
    ctrl(model, data) = ctrl(model, hover) - K * dx;
    mj_step(model, data);
    // #endregion
  }
  return flight;
}

int main() {
  const Model model = load_model("drone");
  const Data hover = make_data(model);
  mj_resetDataKeyframe(model, hover, 0);
  const MatrixXd K = design(model, hover);
  std::printf("state %ld numbers, K %ld x %ld\n",
              static_cast<long>(model->nq + model->nv + model->na), K.rows(),
              K.cols());

  MatrixXd blind = K;  // as if each thrust were right
  blind.rightCols(model->na).setZero();
  for (int rotor = 0; rotor < model->nu; ++rotor)
    model->actuator_dynprm[mjNDYN * rotor] = model->opt.timestep;
  const MatrixXd prompt = design(model, hover);
  for (int rotor = 0; rotor < model->nu; ++rotor)
    model->actuator_dynprm[mjNDYN * rotor] = 0.05;

  std::vector<double> which, time, tilt;
  double flights = 0;
  const auto show = [&](const char* name, const char* key, const MatrixXd& gain,
                        double degrees) {
    const bool large = degrees > 5;
    const Flight flight = fly(model, hover, gain, degrees, large);
    const double end = flight.time.back();
    if (flight.lands)
      std::printf("%-27s %2.0f  on the floor after %.2f s\n", name, degrees,
                  end);
    else
      std::printf("%-27s %2.0f  after %.0f s off by %.3f m\n", name, degrees,
                  end, flight.off);
    if (large) return;
    result(std::string(key) + "_end", end);
    which.insert(which.end(), flight.time.size(), ++flights);
    time.insert(time.end(), flight.time.begin(), flight.time.end());
    tilt.insert(tilt.end(), flight.tilt.begin(), flight.tilt.end());
  };
  std::printf("start tilted by, in degrees\n");
  show("thrusts in the state", "large", K, 50);
  show("thrusts in the state", "whole", K, 5);
  show("their columns of K set to 0", "blind", blind, 5);
  show("K for rotors without a lag", "prompt", prompt, 5);
  table("flights", {{"which", which}, {"time", time}, {"tilt", tilt}});
}
