#include "physics/whole_view.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mjcourse {
namespace {

using Place = std::array<double, 3>;

Simulation watched(const std::string& mjcf) {
  auto model = load_model_text("<mujoco>" + mjcf + "</mujoco>");
  EXPECT_TRUE(model) << model.error().message;
  return Simulation(*std::move(model));
}

// MuJoCo is told what it is to see.
const std::string kBall =
    "<statistic center='0 0 5' extent='1'/><worldbody><body pos='0 0 5'><freejoint/>"
    "<geom size='0.1'/></body><geom type='plane' size='9 9 1'/></worldbody>";

TEST(WholeView, IsMujocosWhereNothingLeavesIt) {
  Simulation ball = watched(kBall);
  WholeView view(ball.model());
  for (int i = 0; i < 2; ++i) {
    view.add(ball);
    EXPECT_EQ(view.center(), (Place{0, 0, 5}));
    EXPECT_EQ(view.extent(), 1);
    ball.advance(0.2);
  }
}

TEST(WholeView, SeesWhatFalls) {
  Simulation ball = watched(kBall);
  WholeView view(ball.model());
  view.add(ball);
  ball.data()->qpos[2] = 3;
  ball.forward();
  view.add(ball);
  EXPECT_EQ(view.center()[0], 0);
  EXPECT_NEAR(view.center()[2], 4, 1e-12);
  EXPECT_NEAR(view.extent(), std::hypot(0.2, 0.2, 2.2) / 2 / 0.6, 1e-12);
  // But not what falls for ever.
  ball.data()->qpos[2] = -100;
  ball.forward();
  view.add(ball);
  EXPECT_EQ(view.center(), (Place{0, 0, 5}));
  EXPECT_EQ(view.extent(), 1);
}

// Its bone has been moved away from where the skin was bound to it.
TEST(WholeView, SeesSkins) {
  const Simulation simulation = watched(
      "<statistic center='0 0 1' extent='2'/>"
      "<worldbody><body name='bone' pos='0 0 1'><geom size='0.1'/></body></worldbody>"
      "<asset><skin name='skin' vertex='0 0 0 3 0 0 0 1 0' face='0 1 2'>"
      "<bone body='bone' bindpos='0 0 0' bindquat='1 0 0 0' vertid='0 1 2' vertweight='1 1 1'/>"
      "</skin></asset>");
  WholeView view(simulation.model());
  view.add(simulation);
  EXPECT_EQ(view.center(), (Place{1.5, 0.5, 1}));
  EXPECT_NEAR(view.extent(), std::hypot(3, 1) / 2 / 0.6, 1e-6);
}

}  // namespace
}  // namespace mjcourse
