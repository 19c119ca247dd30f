// What scripts find by name (site/press/script/lookups.ts).
#include <mujoco/mjxmacro.h>
#include <mujoco/mujoco.h>

#include "world_fixture.h"

namespace mjcourse {

using LookupsTest = WorldTest;

TEST_F(LookupsTest, JointsHaveTheirPartOfTheState) {
  EXPECT_EQ(number("qpos('free').length"), 7);
  EXPECT_EQ(number("qvel('free').length"), 6);
  EXPECT_EQ(number("qpos('ball').length"), 4);
  EXPECT_EQ(number("qvel('ball').length"), 3);
  EXPECT_EQ(number("qpos('free')[1]"), 2);
  ASSERT_TRUE(world_.run("qpos('slide')[0] = 3; joint('hinge').qvel[0] = 4"));
  EXPECT_EQ(simulation_.data()->qpos[11], 3);
  EXPECT_EQ(simulation_.data()->qvel[10], 4);
  EXPECT_EQ(number("joint('slide').qposadr"), 11);
  EXPECT_EQ(number("joint('hinge').axis[1]"), 1);
  EXPECT_EQ(number("joint('hinge').xaxis[1]"), 1);
}

TEST_F(LookupsTest, ThingsHaveTheirRowOfEveryField) {
  EXPECT_EQ(number("body('box').xpos[2]"), 3);
  EXPECT_EQ(number("body('box').mass"), 2);
  EXPECT_EQ(number("body('box').inertia.length"), 3);
  EXPECT_EQ(number("geom('side').size[0]"), 0.1);
  EXPECT_EQ(number("geom('side').xpos[1]"), 2);
  EXPECT_EQ(number("site('tip').xpos[2]"), 3.5);
  ASSERT_TRUE(world_.run("body('box').mass = 5; body('box').xfrc_applied[2] = 7"));
  EXPECT_EQ(simulation_.model()->body_mass[1], 5);
  EXPECT_EQ(simulation_.data()->xfrc_applied[6 + 2], 7);
  simulation_.step(10);
  EXPECT_EQ(number("body('box').xpos[2]"), simulation_.data()->xpos[3 + 2]);
}

TEST_F(LookupsTest, SensorsAndControls) {
  ASSERT_TRUE(world_.run("ctrl('motor')[0] = 2; step(50)"));
  EXPECT_EQ(simulation_.data()->ctrl[0], 2);
  EXPECT_GT(number("sensor('angle')[0]"), 0);
  EXPECT_EQ(number("sensor('place').length"), 3);
  EXPECT_EQ(number("sensor('place')[1]"), simulation_.data()->sensordata[2]);
}

TEST_F(LookupsTest, UnknownNamesAreErrors) {
  EXPECT_EQ(value_error("1 + qpos('hingee')[0]"),
            "E-script-name 1:11+6 no joint is named `hingee` | did you mean `hinge`?");
  EXPECT_EQ(value_error("body('nothing').xpos[0]"),
            "E-script-name 1:7+7 no body is named `nothing` | known: world, box, bob, cart, wheel");
  EXPECT_EQ(value_error("ctrl('moto')"),
            "E-script-name 1:7+4 no actuator is named `moto` | did you mean `motor`?");
  EXPECT_EQ(value_error("sensor('')"),
            "E-script-name 1:1+6 no sensor is named `` | known: angle, place");
  EXPECT_EQ(
      value_error("body('box').xpso"),
      "E-script-name 1:13+4 body('box').xpso does not exist | did you mean `body('box').xpos`?");
  EXPECT_EQ(value_error("qpos('hinge')[1]"),
            "E-script-range 1:1+16 qpos('hinge')[1] is out of range 0..0 | ");
  EXPECT_EQ(run_error("body('box').mass = NaN"),
            "E-script-value 1:1+16 body('box').mass = NaN: not a finite number | "
            "look for a division by 0, or a root or a logarithm of a negative number");
  EXPECT_EQ(run_error("body('box').xpos = [1, 2, 3]"),
            "E-script-value 1:1+16 body('box').xpos cannot be assigned | it is an array: "
            "body('box').xpos[0] = …, or body('box').xpos.set([…])");
}

// mjxmacro.h tells the fields with a row for each body or joint; the TypeScript names them.
TEST_F(LookupsTest, NoFieldOfBodiesAndJointsIsForgotten) {
  const auto expect_member = [&](const std::string& rows, const std::string& name) {
    const std::string owner = rows == "nbody" ? "body('box')" : "joint('free')";
    if (rows != "nbody" && rows != "njnt") return;
    const auto result = world_.run(owner + "." + name);
    EXPECT_TRUE(result) << shown(result.error());
  };
#define X(type, name, rows, columns) expect_member(#rows, #name);
  MJDATA_POINTERS
#undef X
}

}  // namespace mjcourse
