// Lesson 3.4: from where does the leg come back?
//
// INPUT    balancing_leg.xml with its torques limited to 6 N m, and LQR's gains
//          in its actuators
// PROCESS  start it at many leans and speeds, and see whether it comes upright;
//          seek the fastest push that it survives, by halving, for other
//          weights and other shares of the gain
// OUTPUT   these pushes, and the one that the energy allows; for the lesson,
//          the tables "starts" and "edge"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_4_region

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/lqr.hpp>
#include <string>
#include <vector>

using namespace mjcourse;
using Eigen::MatrixXd, Eigen::Vector3d;

constexpr double kInertia = 1.5, kPull = 5 * 9.81 * 0.45;  // kg m^2, N m/rad

// u = -share K dx, by the actuators themselves.
void close_loop(const Model& model, double weight, double share) {
  mju_zero(model->actuator_biasprm, mjNBIAS * model->nu);  // open it first
  const Data upright = make_data(model);
  MatrixXd Q = MatrixXd::Zero(6, 6);
  Q.diagonal().head<3>().fill(1);
  const Linear step = linearise(model, upright);
  const MatrixXd K = share * lqr(step, Q, weight * MatrixXd::Identity(3, 3));
  for (int axis = 0; axis < 3; ++axis) {
    model->actuator_biasprm[mjNBIAS * axis + 1] = -K(axis, axis);
    model->actuator_biasprm[mjNBIAS * axis + 2] = -K(axis, 3 + axis);
  }
}

// #region comes_back
// Does it come upright, from this lean about y and this speed?
bool comes_back(const Model& model, const Data& data, double lean,
                double speed) {
  mj_resetData(model, data);
  const Vector3d y(0, 1, 0);
  mju_axisAngle2Quat(data->qpos, y.data(), lean);
  data->qvel[1] = speed;
  while (data->time < 8) {
    mj_step(model, data);
    const double angle = data->actuator_length[1];
    if (std::abs(angle) > 1) return false;
    if (std::hypot(angle, data->qvel[1]) < 0.01) return true;
  }
  return false;
}
// #endregion

double fastest(const Model& model, const Data& data, double lean) {
  double low = -lean * std::sqrt(kPull / kInertia), high = 4;  // rad/s
  while (high - low > 1e-3) {
    const double speed = (low + high) / 2;
    (comes_back(model, data, lean, speed) ? low : high) = speed;
  }
  return low;
}

// #region edge
// The speed with which the leg, pulled back by all of the torque, just stops
// where gravity pulls as hard.
double edge(double lean, double torque) {
  const double last = std::asin(torque / kPull);
  const double work = torque * (last - lean);
  const double fall = kPull * (std::cos(lean) - std::cos(last));
  return std::sqrt(2 / kInertia * (work - fall));
}
// #endregion

void limit(const Model& model, double torque) {
  for (int axis = 0; axis < 3; ++axis) {
    model->actuator_forcerange[2 * axis] = -torque;
    model->actuator_forcerange[2 * axis + 1] = torque;
  }
}

int main() {
  Model model = load_model("balancing_leg");
  const Data data = make_data(model);
  std::printf("fastest push (rad/s)\n     R  share  survived\n");
  for (const auto& [weight, share] :
       {std::pair{1.0, 1.0}, std::pair{1e-2, 1.0}, std::pair{1e-4, 1.0},
        std::pair{1.0, 0.6}, std::pair{1.0, 5.0}}) {
    close_loop(model, weight, share);
    const double push = fastest(model, data, 0);
    std::printf("%6.0e  %5.1f  %8.2f\n", weight, share, push);
    if (weight == 1 && share == 1) result("push", push);
  }
  const double six = 6, rate = std::sqrt(kPull / kInertia);  // N m, 1/s
  std::printf("by the energy  %8.2f\n", edge(0, six));
  std::printf("by the line    %8.2f\n", six / kPull * rate);
  result("edge", edge(0, six));
  result("last", std::asin(six / kPull) * 180 / M_PI);

  close_loop(model, 1, 1);
  const double degree = M_PI / 180;
  std::vector<double> leans, speeds, back;
  for (int i = -10; i <= 10; ++i) {
    for (int j = -10; j <= 10; ++j) {
      leans.push_back(2.4 * i);
      speeds.push_back(0.2 * j);
      back.push_back(comes_back(model, data, 2.4 * i * degree, 0.2 * j));
    }
  }
  table("starts", {{"lean", leans}, {"speed", speeds}, {"back", back}});

  std::vector<double> limits, at, measured, energy;
  double apart = 0;
  for (const double torque : {3.0, 6.0, 9.0}) {
    limit(model, torque);
    for (double lean = -24; lean * degree < std::asin(torque / kPull) - 0.02;
         lean += 3) {
      limits.push_back(torque);
      at.push_back(lean);
      measured.push_back(fastest(model, data, lean * degree));
      energy.push_back(edge(lean * degree, torque));
      apart = std::max(apart, std::abs(measured.back() - energy.back()));
    }
  }
  std::printf("%zu edges: within 0.02 rad/s of the energy's: %s\n", at.size(),
              apart < 0.02 ? "yes" : "no");
  table("edge", {{"limit", limits},
                 {"lean", at},
                 {"measured", measured},
                 {"energy", energy}});
}
