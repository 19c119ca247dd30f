#include "physics/simulation.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

namespace mjcourse {
namespace {

Simulation simulation_of(const std::string& mjcf) {
  auto model = load_model_text(mjcf);
  EXPECT_TRUE(model.has_value()) << model.error().message;
  return Simulation(std::move(model.value()));
}

// Falls freely: z(t) = 1 - 9.81 t²/2, up to the integrator's error.
const std::string falling = R"(<mujoco><option timestep="0.01"/><worldbody>
    <body pos="0 0 1"><joint name="drop" type="slide" axis="0 0 1"/><geom size="0.1"/></body>
  </worldbody>
  <keyframe><key name="low" qpos="-0.5"/><key name="high" qpos="0.5" time="3"/></keyframe>
</mujoco>)";

// A spring too stiff for the timestep: each step overshoots further.
const std::string exploding = R"(<mujoco><option timestep="0.01" gravity="0 0 0"/><worldbody>
    <body><joint name="spring" type="slide" axis="1 0 0" stiffness="1e6" ref="0" springref="1"/>
      <geom size="0.1" mass="1"/></body>
  </worldbody></mujoco>)";

testing::AssertionResult says(const Simulation& simulation, const std::string& words) {
  const std::string trouble = simulation.trouble() ? simulation.trouble()->what : "(no trouble)";
  if (trouble.find(words) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "the trouble is: " << trouble;
}

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

TEST(Simulation, BeginsForwarded) {
  Simulation simulation = simulation_of(falling);
  EXPECT_EQ(simulation.data()->time, 0);
  EXPECT_DOUBLE_EQ(simulation.data()->xpos[3 + 2], 1);
  EXPECT_NEAR(simulation.data()->qacc[0], -9.81, 1e-12);
  EXPECT_FALSE(simulation.trouble());
}

TEST(Simulation, AdvancesByTheNearestNumberOfSteps) {
  Simulation simulation = simulation_of(falling);
  simulation.advance(0.5);
  EXPECT_NEAR(simulation.data()->time, 0.5, 1e-12);
  EXPECT_NEAR(simulation.data()->qpos[0], -9.81 * 0.5 * 0.5 / 2, 0.03);
  simulation.advance(0.004);  // less than half a step
  EXPECT_NEAR(simulation.data()->time, 0.5, 1e-12);
  simulation.step(3);
  EXPECT_NEAR(simulation.data()->time, 0.53, 1e-12);
}

TEST(Simulation, ResetsToItsStartAndToKeyframes) {
  Simulation simulation = simulation_of(falling);
  simulation.step(10);
  simulation.reset();
  EXPECT_EQ(simulation.data()->time, 0);
  EXPECT_EQ(simulation.data()->qpos[0], 0);
  ASSERT_TRUE(simulation.reset_to_keyframe("high").has_value());
  EXPECT_EQ(simulation.data()->qpos[0], 0.5);
  EXPECT_DOUBLE_EQ(simulation.data()->xpos[3 + 2], 1.5);
  ASSERT_TRUE(simulation.reset_to_keyframe(0).has_value());
  EXPECT_EQ(simulation.data()->qpos[0], -0.5);
  EXPECT_FALSE(simulation.trouble());
}

TEST(Simulation, KnowsItsKeyframes) {
  Simulation simulation = simulation_of(falling);
  EXPECT_EQ(simulation.reset_to_keyframe("hihg").error(),
            "there is no keyframe `hihg`; did you mean `high`?");
  EXPECT_EQ(simulation.reset_to_keyframe(2).error(), "there is no keyframe 2; the model has 2");
  EXPECT_FALSE(simulation.reset_to_keyframe(-1).has_value());
}

// When MuJoCo, left to itself, first resets a simulation of `mjcf`.
double time_of_first_reset(const std::string& mjcf) {
  Simulation simulation = simulation_of(mjcf);
  double time = 0;
  while (simulation.data()->time >= time && time < 10) {
    time = simulation.data()->time;
    mj_step(simulation.model().get(), simulation.data().get());
  }
  return time;
}

TEST(Simulation, StopsWhenItDiverges) {
  Simulation simulation = simulation_of(exploding);
  simulation.advance(10);
  ASSERT_TRUE(simulation.stopped());
  std::ostringstream time;
  time << time_of_first_reset(exploding);
  EXPECT_TRUE(says(simulation, "the simulation diverged at t = " + time.str() + " s: "));
  EXPECT_TRUE(says(simulation, "of joint `spring`"));

  const double stopped_at = simulation.data()->time;
  simulation.step(5);
  EXPECT_EQ(simulation.data()->time, stopped_at);

  simulation.reset();
  EXPECT_FALSE(simulation.trouble());
  simulation.step();
  EXPECT_FALSE(simulation.stopped());
}

TEST(Simulation, SeesStepsThatOthersMade) {
  Simulation simulation = simulation_of(exploding);
  for (int i = 0; i < 1000; ++i) mj_step(simulation.model().get(), simulation.data().get());
  EXPECT_FALSE(simulation.trouble());
  simulation.watch();
  EXPECT_TRUE(simulation.stopped());
  EXPECT_TRUE(says(simulation, "diverged"));
}

TEST(Simulation, SeesAStateThatIsNoNumber) {
  Simulation simulation = simulation_of(falling);
  simulation.data()->qvel[0] = not_a_number;
  simulation.forward();
  EXPECT_TRUE(says(simulation, "qvel[0] of joint `drop`"));

  simulation.reset();
  simulation.data()->qpos[0] = std::numeric_limits<double>::infinity();
  simulation.step();
  EXPECT_TRUE(says(simulation, "qpos[0] of joint `drop`"));
}

TEST(Simulation, NamesTheJointThatAPositionBelongsTo) {
  Simulation simulation = simulation_of(R"(<mujoco><worldbody>
      <body><joint name="ball" type="ball"/><geom size="0.1"/></body>
      <body><joint name="hinge"/><geom size="0.1"/></body>
    </worldbody></mujoco>)");
  simulation.data()->qpos[3] = not_a_number;
  simulation.watch();
  EXPECT_TRUE(says(simulation, "qpos[3] of joint `ball`"));
  simulation.reset();
  simulation.data()->qpos[4] = not_a_number;
  simulation.watch();
  EXPECT_TRUE(says(simulation, "qpos[4] of joint `hinge`"));
}

TEST(Simulation, SeesTimeRunBackwards) {
  Simulation simulation = simulation_of(falling);
  simulation.step(10);
  mj_resetData(simulation.model().get(), simulation.data().get());
  simulation.watch();
  EXPECT_TRUE(says(simulation, "restarted at t = 0.1 s"));
}

TEST(Simulation, ReportsAWarningAndGoesOn) {
  Simulation simulation = simulation_of(R"(<mujoco><worldbody>
      <body><joint name="motor"/><geom size="0.1"/></body></worldbody>
      <actuator><motor joint="motor"/></actuator></mujoco>)");
  simulation.data()->ctrl[0] = not_a_number;
  simulation.step(5);
  EXPECT_TRUE(says(simulation, "MuJoCo warns at t = 0"));
  EXPECT_FALSE(simulation.stopped());
  EXPECT_GT(simulation.data()->time, 0);
}

TEST(Simulation, ReportsWhatElseMujocoWarnsOf) {
  Simulation simulation = simulation_of(falling);
  mjcb_passive = [](const mjModel*, mjData*) { mju_warning("it is slippery"); };
  simulation.step();
  mjcb_passive = nullptr;
  EXPECT_TRUE(says(simulation, "MuJoCo warns: it is slippery"));
  EXPECT_FALSE(simulation.stopped());
}

TEST(Simulation, TurnsAnErrorOfMujocosIntoTrouble) {
  Model model = load_model_text(falling).value();
  model->nstack = 1;  // mj_forward needs more
  const Simulation simulation(std::move(model));
  EXPECT_TRUE(simulation.stopped());
  EXPECT_TRUE(says(simulation, "MuJoCo gave up at t = 0 s: "));
}

}  // namespace
}  // namespace mjcourse
