// Lesson 3.3: a line, followed by servos and by torques at the hand.
//
// INPUT    planar_arm.xml; a straight line of 0.2 m, to be followed in 0.5 s
// PROCESS  follow it with servos that a plan leads, as in lesson 5.1, and with
//          Lambda; then with 0.5 kg in the hand that no controller knows
// OUTPUT   how far the hand is from where it should be, at most
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_3_follow

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <string>

#include "l3_3_hand.hpp"

using namespace mjcourse;
using Eigen::Matrix2d, Eigen::Vector2d, Eigen::Vector3d;

constexpr double kSeconds = 0.5;
const Vector2d kLine(-0.2, 0);  // m

struct Wanted {
  Vector2d x, v, a;
};

Wanted on_the_line(const Vector2d& start, double time) {
  const double u = std::min(1.0, time / kSeconds), T = kSeconds;
  return {start + kLine * (u * u * u * (10 + u * (6 * u - 15))),
          kLine * (30 * u * u * (1 - u) * (1 - u)) / T,
          kLine * (60 * u * (1 - u) * (1 - 2 * u)) / (T * T)};
}

// #region servos
// A plan that damped least squares leads, and stiff servos that follow it.
Vector3d servos(const Model& model, const Data& data, const Data& plan,
                const Wanted& to) {
  mj_kinematics(model, plan);
  mj_comPos(model, plan);
  const Eigen::Matrix<double, 2, 3> J = jacobian_of(model, plan);
  const Vector2d is(plan->site_xpos + 3 * id_of(model, mjOBJ_SITE, "hand"));
  const Matrix2d damped = J * J.transpose() + 4e-4 * Matrix2d::Identity();
  const Vector3d turn = J.transpose() * damped.inverse() * (to.x - is);
  qpos(model, plan) += turn;
  const Vector3d kp(400, 400, 40), kd(20, 10, 0.8);
  const Vector3d lag = qpos(model, plan) - qpos(model, data);
  const Vector3d slow = turn / model->opt.timestep - qvel(model, data);
  return kp.cwiseProduct(lag) + kd.cwiseProduct(slow);
}
// #endregion

// #region operational
Vector3d operational(const Hand& hand, const Vector3d& v, const Wanted& to) {
  const auto& J = hand.J;
  const Eigen::Matrix3d inverse = hand.M.inverse();
  const Matrix2d lambda = (J * inverse * J.transpose()).inverse();
  const Vector2d a =
      to.a + 100 * (to.x - hand.x) + 20 * (to.v - hand.v) - hand.drift;
  const Vector3d calm = -0.2 * v;
  return hand.c + calm + J.transpose() * lambda * (a - J * inverse * calm);
}
// #endregion

int main() {
  const Model known = load_model("planar_arm"), real = load_model("planar_arm");
  const int body = id_of(real, mjOBJ_BODY, "hand");
  const double light = real->body_mass[body];
  std::printf("%-20s %13s %13s\n", "off the line (mm)", "empty hand",
              "0.5 kg in it");
  for (const bool space : {false, true}) {
    double off[2];
    for (const bool loaded : {false, true}) {
      real->body_mass[body] = light + 0.5 * loaded;
      const Data data = make_data(real), plan = make_data(known);
      const Data mind = make_data(known), scratch = make_data(known);
      mj_forward(real, data);
      const Vector2d start(data->site_xpos +
                           3 * id_of(real, mjOBJ_SITE, "hand"));
      off[loaded] = 0;
      for (int step = 0; step < 500; ++step) {
        mj_step1(real, data);
        // What the controller takes the arm for: the same state, no load.
        mju_copy(mind->qpos, data->qpos, known->nq);
        mju_copy(mind->qvel, data->qvel, known->nv);
        mj_forward(known, mind);
        const Hand hand = hand_of(known, mind, scratch);
        const Wanted to = on_the_line(start, data->time);
        off[loaded] = std::max(off[loaded], (hand.x - to.x).norm());
        ctrl(real, data) = space ? operational(hand, qvel(real, data), to)
                                 : servos(known, data, plan, to);
        mj_step2(real, data);
      }
    }
    std::printf("%-20s %13.2f %13.2f\n", space ? "Lambda" : "plan and servos",
                1000 * off[0], 1000 * off[1]);
    result(space ? "space" : "servos", 1000 * off[0]);
    result(space ? "space_loaded" : "servos_loaded", 1000 * off[1]);
  }
}
