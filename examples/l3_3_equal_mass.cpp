// Lesson 3.3, challenge: a hand of 1 kg, whichever way it is pushed.
//
// INPUT    planar_arm.xml, at rest and moving; a force sensor in the hand
// PROCESS  push the hand in 12 directions; the controller knows the push
// OUTPUT   the accelerations; checks that they are those of a mass on a spring
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_3_equal_mass

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>

#include "l3_3_hand.hpp"

using namespace mjcourse;
using Eigen::Matrix2d, Eigen::Vector2d, Eigen::Vector3d;

// The torques with which the hand moves as a mass (kg) would that is pushed
// with `push`, and pulled to `home` by a spring of K N/m with a damper of
// D N s/m. J, M, the bias force c, x, v and the drift are in `hand`.
Vector3d as_a_mass(const Hand& hand, const Vector2d& push, const Vector2d& home,
                   double mass, double K, double D) {
  const auto& J = hand.J;
  const Matrix2d lambda = (J * hand.M.inverse() * J.transpose()).inverse();
  // #region answer
  const Vector2d spring = K * (home - hand.x) - D * hand.v;
  const Vector2d wanted = (push + spring) / mass;
  // Lambda times what is missing, less the push, which acts by itself.
  const Vector2d force = lambda * (wanted - hand.drift) - push;
  return hand.c + J.transpose() * force;
  // #starter
  // const Vector2d spring = K * (home - hand.x) - D * hand.v;
  // return hand.c + J.transpose() * spring;  // the lambda is not used yet
  // #wrong counts-the-push-twice: a push at rest
  // const Vector2d spring = K * (home - hand.x) - D * hand.v;
  // const Vector2d wanted = (push + spring) / mass;
  // return hand.c + J.transpose() * (lambda * (wanted - hand.drift));
  // #wrong ignores-the-push: a push at rest
  // const Vector2d spring = K * (home - hand.x) - D * hand.v;
  // const Vector2d wanted = spring / mass;
  // return hand.c + J.transpose() * (lambda * (wanted - hand.drift));
  // #wrong forgets-the-drift: a moving hand
  // const Vector2d spring = K * (home - hand.x) - D * hand.v;
  // const Vector2d wanted = (push + spring) / mass;
  // return hand.c + J.transpose() * (lambda * wanted - push);
  // #wrong forgets-the-bias: a moving hand
  // const Vector2d spring = K * (home - hand.x) - D * hand.v;
  // const Vector2d wanted = (push + spring) / mass;
  // return J.transpose() * (lambda * (wanted - hand.drift) - push);
  // #endregion
}

int main() {
  const Model model = load_model("planar_arm");
  const Data data = make_data(model), scratch = make_data(model);
  const int sensor = id_of(model, mjOBJ_SENSOR, "hand_acceleration");
  const int body = id_of(model, mjOBJ_BODY, "hand");
  const double mass = 1, K = 50, D = 10;
  std::printf("pushed with 2 N   least   most (m/s2)  off (m/s2)\n");
  for (const bool moving : {false, true}) {
    double least = 1e9, most = 0, off = 0;
    for (int degrees = 0; degrees < 360; degrees += 30) {
      mj_resetData(model, data);
      if (moving) qvel(model, data) << 0.5, -2, 1.5;
      mj_forward(model, data);
      const Hand hand = hand_of(model, data, scratch);
      const double angle = degrees * M_PI / 180;
      const Vector2d push(2 * std::cos(angle), 2 * std::sin(angle));
      const Vector2d home =
          moving ? Vector2d(hand.x + Vector2d(0.02, -0.01)) : hand.x;
      data->xfrc_applied[6 * body] = push[0];
      data->xfrc_applied[6 * body + 1] = push[1];
      ctrl(model, data) = as_a_mass(hand, push, home, mass, K, D);
      mj_forward(model, data);
      const Vector2d a(data->sensordata + model->sensor_adr[sensor]);
      const Vector2d truth = (push + K * (home - hand.x) - D * hand.v) / mass;
      least = std::min(least, a.norm());
      most = std::max(most, a.norm());
      off = std::max(off, (a - truth).norm());
      if (!moving) {
        if (!expect_near(a, truth, 1e-6,
                         "a push at rest moves it as it moves 1 kg",
                         "the push also acts without the controller; the "
                         "torques have to add only what is missing"))
          return 0;
      } else {
        expect_near(a, truth, 1e-4, "a moving hand is 1 kg on a spring",
                    "a moving arm has a bias force, and its hand drifts with "
                    "steady joints");
      }
    }
    std::printf("%-15s %7.3f %6.3f %18.3f\n", moving ? "moving" : "at rest",
                least, most, off);
  }
}
