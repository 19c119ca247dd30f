// The fields of `model` and `data` as scripts hold them (site/script/strict-array.ts).
#include <cmath>
#include <nlohmann/json.hpp>

#include "world_fixture.h"

namespace mjcourse {

using StrictArrayTest = WorldTest;

TEST_F(StrictArrayTest, WorksAsATypedArray) {
  ASSERT_TRUE(world_.run("data.qvel.set([1, 2, 3], 2); data.qpos.fill(4)"));
  EXPECT_EQ(number("data.qvel.length"), 11);
  EXPECT_EQ(number("data.qvel.map((v) => 2 * v)[3]"), 4);
  EXPECT_EQ(number("data.qvel.slice(2, 5).reduce((a, b) => a + b)"), 6);
  EXPECT_EQ(number("[...data.qvel].length"), 11);
  EXPECT_DOUBLE_EQ(number("Math.hypot(...data.qvel)"), std::sqrt(14.0));
  EXPECT_EQ(number("(() => { let s = 0; for (const v of data.qvel) s += v; return s; })()"), 6);
  EXPECT_EQ(number("(() => { let s = 0; data.qvel.forEach((v, i) => (s += v * i)); return s; })()"),
            20);
  EXPECT_EQ(number("(() => { const [a, , c] = data.qvel.subarray(2); return a + c; })()"), 4);
  EXPECT_EQ(number("data.qvel.indexOf(3)"), 4);
  EXPECT_EQ(number("data.qvel.at(-11)"), 0);
  EXPECT_EQ(simulation_.data()->qpos[12], 4);
}

TEST_F(StrictArrayTest, PartsAreViewsAndStrict) {
  ASSERT_TRUE(world_.run("data.qvel.subarray(2, 4)[1] = 5"));
  EXPECT_EQ(simulation_.data()->qvel[3], 5);
  ASSERT_TRUE(world_.run("data.qvel.slice()[0] = 8"));
  EXPECT_EQ(simulation_.data()->qvel[0], 0);
  EXPECT_EQ(value_error("data.qvel.slice(0, 2)[2]"),
            "E-script-range 1:22+1 data.qvel.slice(…)[2] is out of range 0..1 | ");
}

TEST_F(StrictArrayTest, RefusesWhatJavaScriptLetsPass) {
  EXPECT_EQ(value_error("data.qpos[-1]"),
            "E-script-range 1:1+13 data.qpos[-1] is out of range 0..12 | ");
  EXPECT_EQ(value_error("data.qpos[0.5]"),
            "E-script-range 1:1+14 data.qpos[0.5] is out of range 0..12 | ");
  EXPECT_EQ(value_error("data.qpos.at(13)"),
            "E-script-range 1:1+9 data.qpos[13] is out of range 0..12 | ");
  EXPECT_EQ(value_error("data.qpos.lenght"),
            "E-script-name 1:11+6 data.qpos has no `lenght` | did you mean `data.qpos.length`?");
  EXPECT_EQ(run_error("data.qvel.fill(NaN)"),
            "E-script-value 1:1+9 every number of data.qvel = NaN: not a finite number | ");
  EXPECT_EQ(run_error("data.qvel.set([1, 0 / 0], 3)"),
            "E-script-value 1:1+9 data.qvel[4] = NaN: not a finite number | ");
  EXPECT_EQ(run_error("data.qvel.set([1, 2], 10)"),
            "E-script-range 1:1+13 data.qvel.set: 2 numbers from 10 on pass its end, 11 | ");
  EXPECT_EQ(run_error("data.qpos[undefined] = 1"),
            "E-script-name 1:11+9 data.qpos has no `undefined` | ");
  EXPECT_EQ(run_error("data.qpos[13] = 1"),
            "E-script-range 1:1+13 data.qpos[13] is out of range 0..12 | ");
}

TEST_F(StrictArrayTest, WholeNumbersStayWhole) {
  EXPECT_EQ(run_error("model.jnt_type[0] = 1.5"),
            "E-script-value 1:1+17 model.jnt_type[0] = 1.5: not a whole number | ");
  EXPECT_EQ(run_error("model.jnt_limited[0] = 300"),
            "E-script-value 1:1+20 model.jnt_limited[0] = 300: not a whole number in 0..255 | ");
  ASSERT_TRUE(world_.run("model.jnt_limited[0] = 1"));
  EXPECT_EQ(simulation_.model()->jnt_limited[0], 1);
}

TEST_F(StrictArrayTest, OneNumberStandsForItselfAndMoreDoNot) {
  ASSERT_TRUE(world_.run("qpos('hinge')[0] = 0.5"));
  EXPECT_EQ(number("2 * qpos('hinge')"), 1);
  EXPECT_EQ(value_error("2 * qpos('free')"),
            "E-script-value 1:5+12 qpos('free') is an array of length 7, not a number | take one "
            "of its numbers: qpos('free')[0]");
  EXPECT_EQ(world_.value("`at ${qpos('free').slice(0, 3)}`").value(), "at 1, 2, 3");
}

}  // namespace mjcourse
