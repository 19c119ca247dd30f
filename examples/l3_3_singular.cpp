// Lesson 3.3: the hand of an arm that is nearly straight.
//
// INPUT    planar_arm.xml, elbow and wrist bent by less and less
// PROCESS  compute Lambda, and the torques that accelerate the hand outwards
//          with 1 m/s^2, without and with damping; then pull the hand towards
//          a point 0.1 m out of reach for 4 s, with three controllers
// OUTPUT   masses, torques and accelerations; the largest torque and speed of
//          each controller, and how far from the point it comes to rest; for
//          the lesson, the table "straight"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_3_singular

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <string>
#include <vector>

#include "l3_3_hand.hpp"

using namespace mjcourse;
using Eigen::Matrix2d, Eigen::Vector2d, Eigen::Vector3d;

// #region damped
constexpr double kDamping = 0.1;  // 1/kg: no direction weighs above 10 kg

Matrix2d lambda_of(const Hand& hand, double damping) {
  const Matrix2d mobility = hand.J * hand.M.inverse() * hand.J.transpose();
  return (mobility + damping * Matrix2d::Identity()).inverse();
}
// #endregion

Vector3d shaped(const Hand& hand, const Vector2d& to, const Vector3d& v,
                double damping) {
  const Matrix2d lambda = lambda_of(hand, damping);
  const Vector2d wanted = 100 * (to - hand.x) - 20 * hand.v;
  return hand.c + hand.J.transpose() * (lambda * (wanted - hand.drift)) -
         0.2 * v;
}

Vector3d spring(const Hand& hand, const Vector2d& to, const Vector3d& v) {
  const Vector2d force = 100 * (to - hand.x) - 15 * hand.v;
  return hand.c + hand.J.transpose() * force - 0.2 * v;
}

void bend(const Model& model, const Data& data, double angle) {
  qpos(model, data) << 0, angle, angle;
  qvel(model, data).setZero();
  mj_forward(model, data);
}

int main() {
  const Model model = load_model("planar_arm");
  const Data data = make_data(model), scratch = make_data(model);
  std::printf(
      "  bent   heaviest (kg)   largest torque (N m)  outwards (m/s2)\n");
  std::printf(
      " (rad)  exact   damped       exact    damped    exact  damped\n");
  std::vector<double> bent, exact_kg, damped_kg, exact_t, damped_t;
  for (int i = 0; i <= 24; ++i) {
    const double angle = std::pow(10, -i / 8.0);
    bend(model, data, angle);
    const Hand hand = hand_of(model, data, scratch);
    const Vector2d out = hand.x.normalized();
    double kg[2], torque[2], gets[2];
    for (const int k : {0, 1}) {
      const Matrix2d lambda = lambda_of(hand, k * kDamping);
      kg[k] = Eigen::SelfAdjointEigenSolver<Matrix2d>(lambda).eigenvalues()[1];
      const Vector3d t = hand.J.transpose() * (lambda * out);
      torque[k] = t.cwiseAbs().maxCoeff();
      gets[k] = out.dot(hand.J * hand.M.ldlt().solve(t));
    }
    bent.push_back(angle);
    exact_kg.push_back(kg[0]), damped_kg.push_back(kg[1]);
    exact_t.push_back(torque[0]), damped_t.push_back(torque[1]);
    if (i % 4 == 0)
      std::printf("%6.3f %9.1f %6.2f %12.2f %8.2f %9.2f %7.3f\n", angle, kg[0],
                  kg[1], torque[0], torque[1], gets[0], gets[1]);
  }
  table("straight", {{"bent", bent},
                     {"exact", exact_kg},
                     {"damped", damped_kg},
                     {"torque", exact_t},
                     {"damped_torque", damped_t}});

  std::printf("out of reach      torque (N m)  speed (rad/s)   off (m)\n");
  const struct {
    const char *label, *name;
    double damping;
  } kinds[] = {{"Lambda, exact", "exact", 0},
               {"Lambda, damped", "damped", kDamping},
               {"spring, no Lambda", "spring", -1}};
  for (const auto& kind : kinds) {
    mj_resetData(model, data);
    double stopped = 0;
    double torque = 0, speed = 0;
    const Vector2d to(1.05 * std::cos(0.6), 1.05 * std::sin(0.6));
    while (data->time < 4) {
      mj_step1(model, data);
      const Hand hand = hand_of(model, data, scratch);
      const Vector3d v = qvel(model, data);
      const Vector3d t = kind.damping < 0 ? spring(hand, to, v)
                                          : shaped(hand, to, v, kind.damping);
      ctrl(model, data) = t;
      if (!(t.cwiseAbs().maxCoeff() < 1e6)) {  // or not a number
        stopped = data->time;
        break;
      }
      torque = std::max(torque, t.cwiseAbs().maxCoeff());
      speed = std::max(speed, v.cwiseAbs().maxCoeff());
      mj_step2(model, data);
    }
    if (stopped > 0) {
      std::printf("%-17s beyond 10^6 within half a second: %s\n", kind.label,
                  stopped < 0.5 ? "yes" : "no");
      continue;
    }
    mj_forward(model, data);
    const double off = (hand_of(model, data, scratch).x - to).norm();
    std::printf("%-17s %12.3g %14.3g %9.3f\n", kind.label, torque, speed, off);
    result(kind.name + std::string("_torque"), torque);
    result(kind.name + std::string("_speed"), speed);
    result(kind.name + std::string("_off"), off);
  }
}
