#include "physics/whole_view.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mjcourse {
namespace {

Simulation watched(const std::string& mjcf) {
  auto model = load_model_text("<mujoco>" + mjcf + "</mujoco>");
  EXPECT_TRUE(model) << model.error().message;
  return Simulation(*std::move(model));
}

// MuJoCo draws nothing beyond zfar times the extent.
const std::string kFar = "<visual><map zfar='1000'/></visual>";

WholeView view_of(const Simulation& simulation, const Outlook& outlook = {}) {
  return WholeView(simulation.model(), outlook);
}

// Is the ball around `center` in the picture? By its distances from the picture's four sides.
bool sees(const WholeView& view, const Vector& center, double radius = 0, double fovy = 45) {
  const auto [azimuth, elevation, aspect] = view.outlook();
  const auto [target, distance] = view.place();
  const double a = azimuth * M_PI / 180, e = elevation * M_PI / 180;
  const Vector away{std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
  const Vector right{std::sin(a), -std::cos(a), 0};
  const Vector up{-std::sin(e) * std::cos(a), -std::sin(e) * std::sin(a), std::cos(e)};
  const Vector from_target{center[0] - target[0], center[1] - target[1], center[2] - target[2]};
  const double depth = dot(from_target, away) + distance;
  const double high = std::tan(fovy * M_PI / 360), wide = high * aspect;
  const double below = (high * depth - std::abs(dot(from_target, up))) / std::hypot(high, 1);
  const double within = (wide * depth - std::abs(dot(from_target, right))) / std::hypot(wide, 1);
  return std::min(below, within) >= radius - 1e-5;
}

// MuJoCo is told what it is to see.
const std::string kBall =
    "<statistic center='0 0 5' extent='1'/><worldbody><body pos='0 0 5'><freejoint/>"
    "<geom size='0.1'/></body><geom type='plane' size='2 2 1' pos='0 0 4'/></worldbody>";

TEST(WholeView, IsMujocosWhereNothingLeavesIt) {
  Simulation ball = watched(kBall);
  WholeView view = view_of(ball);
  for (int i = 0; i < 2; ++i) {
    view.add(ball);
    EXPECT_EQ(view.place().target, (Vector{0, 0, 5}));
    EXPECT_EQ(view.place().distance, 1.5);
    ball.advance(0.2);
  }
}

TEST(WholeView, SeesWhatFalls) {
  Simulation ball = watched(kBall);
  WholeView view = view_of(ball);
  view.add(ball);
  ball.data()->qpos[2] = 3;
  ball.forward();
  view.add(ball);
  EXPECT_TRUE(sees(view, {0, 0, 5}, 0.1));
  EXPECT_TRUE(sees(view, {0, 0, 3}, 0.1));
  // But not what falls for ever.
  ball.data()->qpos[2] = -100;
  ball.forward();
  view.add(ball);
  EXPECT_EQ(view.place().target, (Vector{0, 0, 5}));
  EXPECT_EQ(view.place().distance, 1.5);
}

// It is far larger than the geoms, which are all that MuJoCo measures.
TEST(WholeView, SeesSkins) {
  const Simulation simulation = watched(
      kFar +
      "<worldbody><body name='bone' pos='0 0 1'><geom size='0.1'/></body></worldbody>"
      "<asset><skin name='skin' vertex='0 0 0 30 0 0 0 10 0' face='0 1 2'>"
      "<bone body='bone' bindpos='0 0 0' bindquat='1 0 0 0' vertid='0 1 2' vertweight='1 1 1'/>"
      "</skin></asset>");
  WholeView view = view_of(simulation);
  view.add(simulation);
  EXPECT_TRUE(sees(view, {0, 0, 1}));
  EXPECT_TRUE(sees(view, {30, 0, 1}));
  EXPECT_TRUE(sees(view, {0, 10, 1}));
}

TEST(WholeView, SeesGeomsBeyondTheStatistic) {
  const Simulation simulation = watched(
      kFar +
      "<statistic extent='0.1'/><worldbody><geom type='box' size='0.5 0.1 0.1' pos='2 0 0'/>"
      "<geom type='capsule' size='0.1 0.5' pos='-2 0 0'/></worldbody>");
  WholeView view = view_of(simulation, {.elevation = -10});
  view.add(simulation);
  for (const double y : {-0.1, 0.1}) {
    EXPECT_TRUE(sees(view, {2.5, y, -0.1}) && sees(view, {2.5, y, 0.1})) << y;
  }
  EXPECT_TRUE(sees(view, {-2, 0, 0.5}, 0.1) && sees(view, {-2, 0, -0.5}, 0.1));
  EXPECT_FALSE(sees(view, {2.9, 0, 0}) && sees(view, {-2.5, 0, 0}));  // nor much else
}

// The list of shapes begins with room for 10000.
TEST(WholeView, SeesMoreShapesThanItsListHasAtFirst) {
  std::string sites;
  for (int i = 0; i < 12000; ++i) sites += "<site pos='" + std::to_string(i * 1e-3) + " 0 0'/>";
  Simulation simulation = watched("<worldbody><geom size='0.1'/>" + sites + "</worldbody>");
  WholeView view = view_of(simulation);
  view.add(simulation);
  EXPECT_TRUE(sees(view, {11.9, 0, 0}));
  EXPECT_EQ(simulation.data()->warning[mjWARN_VGEOMFULL].number, 0);
  simulation.advance(0.01);
  EXPECT_FALSE(simulation.trouble());
}

// Farther away nothing at all would be drawn.
TEST(WholeView, StaysWhereTheModelIsDrawn) {
  const std::string wide = "<worldbody><geom type='box' size='4 4 0.1'/></worldbody>";
  for (const std::string zfar : {"30", "3"}) {
    const Simulation box = watched("<statistic center='0 0 0' extent='1'/><visual><map zfar='" +
                                   zfar + "'/></visual>" + wide);
    WholeView view = view_of(box);
    view.add(box);
    EXPECT_EQ(sees(view, {4, 0, 0}), zfar == "30");
    EXPECT_LT(view.place().distance, std::stod(zfar));
  }
}

TEST(WholeView, SeesWhereItWasWhatFallsForEver) {
  Simulation ball = watched(
      kFar +
      "<statistic extent='0.1'/><worldbody><geom size='0.1' pos='-2 0 0'/><body pos='2 0 0'>"
      "<freejoint/><geom size='0.1'/></body></worldbody>");
  WholeView view = view_of(ball);
  view.add(ball);
  ball.data()->qpos[0] = 5;
  ball.forward();
  view.add(ball);
  EXPECT_TRUE(sees(view, {5, 0, 0}, 0.1));
  ball.data()->qpos[0] = 100;
  ball.forward();
  view.add(ball);
  EXPECT_TRUE(sees(view, {2, 0, 0}, 0.1) && sees(view, {-2, 0, 0}, 0.1));
  EXPECT_FALSE(sees(view, {5, 0, 0}));
}

// It has left the plane at its lower edge. Planes are floors: their ends need not be seen.
TEST(WholeView, SeesWhatRollsOffAPlane) {
  Simulation ball = watched(
      "<worldbody><geom type='plane' size='3 3 1' euler='0 30 0'/><geom type='plane' size='0 5 1'/>"
      "<body pos='2.3 0 -1.2'><freejoint/><geom size='0.05'/></body></worldbody>");
  WholeView view = view_of(ball);
  view.add(ball);
  EXPECT_FALSE(sees(view, {-2.6, 0, 1.5}));
  ball.data()->qpos[2] = -9;
  ball.forward();
  view.add(ball);
  EXPECT_TRUE(sees(view, {2.3, 0, -9}, 0.05));
  EXPECT_FALSE(sees(view, {-2.6, 0, 1.5}));
}

// Sites and tendons are; what is in a group above 2 or has no colour is not. What a sensor measures
// is no part of the model.
TEST(WholeView, SeesWhatIsDrawn) {
  const Simulation simulation = watched(
      "<statistic center='0 0 0' extent='1'/><worldbody><geom size='0.1'/>"
      "<body><geom size='0.1' pos='0 0 7' group='3'/></body><geom size='0.1' pos='0 0 7' rgba='1 1 "
      "1 0'/>"
      "<site name='a' pos='2 0 0'/><site name='b' pos='3 0 0' group='3'/><site name='eye' pos='0 0 "
      "0.2'/></worldbody>"
      "<sensor><rangefinder site='eye'/></sensor><tendon><spatial width='0.02'><site "
      "site='a'/><site site='b'/></spatial></tendon>");
  WholeView view = view_of(simulation);
  view.add(simulation);
  EXPECT_TRUE(sees(view, {2, 0, 0}));
  EXPECT_TRUE(sees(view, {3, 0, 0}, 0.02));
  EXPECT_FALSE(sees(view, {0, 0, 7}));
}

TEST(WholeView, KnowsTheCamerasAngleAndThePicturesShape) {
  const Simulation simulation = watched(
      "<visual><global fovy='20'/></visual><worldbody><geom type='box' size='1 1 1'/></worldbody>");
  WholeView view = view_of(simulation, {.azimuth = 0, .elevation = -30, .aspect = 0.5});
  view.add(simulation);
  for (int i = 0; i < 8; ++i) {
    const Vector corner{i % 2 * 2.0 - 1, i / 2 % 2 * 2.0 - 1, i / 4 * 2.0 - 1};
    EXPECT_TRUE(sees(view, corner, 0, 20)) << i;
  }
}

}  // namespace
}  // namespace mjcourse
