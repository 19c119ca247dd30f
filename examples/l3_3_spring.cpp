// Lesson 3.3: three ways to hold a hand, pushed and released.
//
// INPUT    planar_arm.xml; three controllers: servos in the joints, a spring
//          at the hand, and a spring whose force Lambda shapes
// PROCESS  push the hand with 1 N in 24 directions, and see where it comes to
//          rest; then let it rest, and move its target by 10 mm in the same
//          24 directions, and see where it is a tenth of a second later
// OUTPUT   the softest and the stiffest direction, the fastest and the
//          slowest; for the lesson, the table "shapes"
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_3_spring

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <string>
#include <vector>

#include "l3_3_hand.hpp"

using namespace mjcourse;
using Eigen::Matrix2d, Eigen::Vector2d, Eigen::Vector3d;

struct Target {
  Vector3d q;
  Vector2d x;
};

// #region controllers
// Servos: each joint has a spring and a damper of its own.
Vector3d servos(const Hand&, const Target& to, const Vector3d& q,
                const Vector3d& v) {
  return 20 * (to.q - q) - 2 * v;
}

// The part of a torque that does not accelerate the hand.
Vector3d beside(const Hand& hand, const Matrix2d& lambda, const Vector3d& t) {
  return t - hand.J.transpose() * (lambda * (hand.J * hand.M.inverse() * t));
}

Matrix2d lambda_of(const Hand& hand) {
  return (hand.J * hand.M.inverse() * hand.J.transpose()).inverse();
}

// A spring of 100 N/m at the hand, with a damper.
Vector3d spring(const Hand& hand, const Target& to, const Vector3d&,
                const Vector3d& v) {
  const Vector2d force = 100 * (to.x - hand.x) - 15 * hand.v;
  return hand.c + hand.J.transpose() * force +
         beside(hand, lambda_of(hand), -0.2 * v);
}

// The same, times Lambda: 100 N/m and 20 N s/m for each kilogram.
Vector3d shaped(const Hand& hand, const Target& to, const Vector3d&,
                const Vector3d& v) {
  const Matrix2d lambda = lambda_of(hand);
  const Vector2d wanted = 100 * (to.x - hand.x) - 20 * hand.v;
  return hand.c + hand.J.transpose() * (lambda * (wanted - hand.drift)) +
         beside(hand, lambda, -0.2 * v);
}
// #endregion

using Controller = Vector3d (*)(const Hand&, const Target&, const Vector3d&,
                                const Vector3d&);

// Where the hand is after so many seconds, from rest (m, from its home).
Vector2d run(const Model& model, Controller controller, const Vector2d& force,
             const Vector2d& shift, double seconds) {
  const Data data = make_data(model), scratch = make_data(model);
  const int body = id_of(model, mjOBJ_BODY, "hand");
  mj_forward(model, data);
  const Hand start = hand_of(model, data, scratch);
  // Of the joint angles that shift the hand, for the servos: the nearest.
  const Vector3d turn =
      start.J.transpose() * (start.J * start.J.transpose()).inverse() * shift;
  const Target to{qpos(model, data) + turn, start.x + shift};
  data->xfrc_applied[6 * body] = force[0];
  data->xfrc_applied[6 * body + 1] = force[1];
  const int steps = std::lround(seconds / model->opt.timestep);
  for (int step = 0; step < steps; ++step) {
    mj_step1(model, data);
    const Hand hand = hand_of(model, data, scratch);
    ctrl(model, data) =
        controller(hand, to, qpos(model, data), qvel(model, data));
    mj_step2(model, data);
  }
  mj_forward(model, data);
  return hand_of(model, data, scratch).x - start.x;
}

int main() {
  const Model model = load_model("planar_arm");
  const struct {
    const char *label, *name;
    Controller controller;
  } kinds[] = {{"servos in the joints", "servos", servos},
               {"spring at the hand", "spring", spring},
               {"shaped by Lambda", "shaped", shaped}};
  std::printf("%-20s  pushed: N/m          after 0.1 s: mm\n", "");
  std::printf("%-20s  softest  stiffest    least    most   aside\n", "");
  std::vector<double> who, angle, rest_x, rest_y, way_x, way_y;
  for (const auto& kind : kinds) {
    double soft = 1e9, stiff = 0, slow = 1e9, fast = 0, aside = 0;
    for (int degrees = 0; degrees <= 360; degrees += 15) {
      const double a = degrees * M_PI / 180;
      const Vector2d way(std::cos(a), std::sin(a)), none(0, 0);
      const Vector2d rest = run(model, kind.controller, way, none, 3);
      const Vector2d soon = run(model, kind.controller, none, 0.01 * way, 0.1);
      soft = std::min(soft, 1 / rest.norm());
      stiff = std::max(stiff, 1 / rest.norm());
      slow = std::min(slow, way.dot(soon));
      fast = std::max(fast, way.dot(soon));
      aside = std::max(aside, std::abs(way[0] * soon[1] - way[1] * soon[0]));
      who.push_back(static_cast<double>(&kind - kinds)),
          angle.push_back(degrees);
      rest_x.push_back(1000 * rest[0]), rest_y.push_back(1000 * rest[1]);
      way_x.push_back(1000 * soon[0]), way_y.push_back(1000 * soon[1]);
    }
    std::printf("%-20s %8.1f %9.1f  %7.2f %7.2f %7.2f\n", kind.label, soft,
                stiff, 1000 * slow, 1000 * fast, 1000 * aside);
    const std::string name = kind.name;
    result(name + "_soft", soft), result(name + "_stiff", stiff);
    result(name + "_ratio", stiff / soft);
    result(name + "_slow", 1000 * slow), result(name + "_fast", 1000 * fast);
    result(name + "_aside", 1000 * aside);
  }
  table("shapes", {{"controller", who},
                   {"degrees", angle},
                   {"rest_x", rest_x},
                   {"rest_y", rest_y},
                   {"way_x", way_x},
                   {"way_y", way_y}});
}
