// The fields of `model` and `data` as scripts hold them (site/press/script/strict-array.ts).
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
            "E-script-value 1:1+9 every number of data.qvel = NaN: not a finite number | "
            "look for a division by 0, or a root or a logarithm of a negative number");
  EXPECT_EQ(run_error("data.qvel.set([1, 0 / 0], 3)"),
            "E-script-value 1:1+9 data.qvel[4] = NaN: not a finite number | "
            "look for a division by 0, or a root or a logarithm of a negative number");
  EXPECT_EQ(run_error("data.qvel.set([1, 2], 10)"),
            "E-script-range 1:1+13 data.qvel.set: 2 numbers from 10 on pass its end, 11 | ");
  EXPECT_EQ(run_error("data.qpos[undefined] = 1"),
            "E-script-name 1:11+9 data.qpos has no `undefined` | ");
  EXPECT_EQ(run_error("data.qpos[13] = 1"),
            "E-script-range 1:1+13 data.qpos[13] is out of range 0..12 | ");
}

TEST_F(StrictArrayTest, WholeNumbersStayWhole) {
  EXPECT_EQ(run_error("model.geom_contype[0] = 1.5"),
            "E-script-value 1:1+21 model.geom_contype[0] = 1.5: not a whole number | ");
  EXPECT_EQ(run_error("model.jnt_limited[0] = 300"),
            "E-script-value 1:1+20 model.jnt_limited[0] = 300: not a whole number in 0..255 | ");
  ASSERT_TRUE(world_.run("model.jnt_limited[0] = 1"));
  EXPECT_EQ(simulation_.model()->jnt_limited[0], 1);
}

TEST_F(StrictArrayTest, WholeNumbersAreWrittenWhereMujocoBearsThem) {
  ASSERT_TRUE(
      world_.run("model.geom_contype[0] = -1; model.geom_group.fill(5); "
                 "model.opt.iterations = 7; model.opt.disableflags = 16"));
  EXPECT_EQ(simulation_.model()->geom_contype[0], -1);
  EXPECT_EQ(simulation_.model()->geom_group[3], 5);
  EXPECT_EQ(
      run_error("model.geom_group[0] = -1"),
      "E-script-value 1:1+19 model.geom_group[0] = -1: not a whole number in 0..2147483647 | ");
  EXPECT_EQ(
      run_error("model.opt.iterations = 100000"),
      "E-script-value 1:1+20 model.opt.iterations = 100000: not a whole number in 0..1000 | ");
  EXPECT_EQ(run_error("model.opt.integrator = 9"),
            "E-script-value 1:1+20 model.opt.integrator = 9: not a whole number in 0..2 | ");
  EXPECT_EQ(
      run_error("model.vis.quality.shadowsize = 9"),
      "E-script-value 1:1+28 model.vis.quality.shadowsize cannot be assigned | MuJoCo computes "
      "it from the model");
  EXPECT_EQ(
      run_error("body('box').jntadr = 9"),
      "E-script-value 1:1+18 body('box').jntadr cannot be assigned | MuJoCo takes its place in "
      "memory from it; change the model instead");
}

// Each would have MuJoCo read or write where nothing of its own is.
TEST_F(StrictArrayTest, PlacesInMemoryStayWhatTheyAre) {
  const std::vector<int> before(simulation_.model()->jnt_qposadr,
                                simulation_.model()->jnt_qposadr + 4);
  for (const std::string attack :
       {"model.jnt_qposadr[1] = 100000000",
        "model.jnt_qposadr.fill(100000000)",
        "model.jnt_qposadr.set([100000000])",
        "model.jnt_qposadr.sort((a, b) => b - a)",
        "model.jnt_qposadr.reverse()",
        "model.jnt_qposadr.copyWithin(0, 1)",
        "model.jnt_qposadr.subarray(1)[0] = 9",
        "new Int32Array(model.jnt_qposadr.buffer)[0] = 9",
        "new DataView(model.jnt_qposadr.buffer)",
        "data.qpos.buffer",
        "model.jnt_qposadr.forEach((value, index, all) => { all[index] = 9 })",
        "model.jnt_qposadr.some((value, index, all) => { all.fill(9) })",
        "Object.defineProperty(model.jnt_qposadr, '1', {value: 9})",
        "Object.freeze(model.jnt_qposadr)",
        "Object.setPrototypeOf(model.jnt_qposadr, {}).set([9])",
        "if (!Reflect.set(model.jnt_qposadr, '1', 9)) throw Error()",
        "Int32Array.prototype.at = function () { this[1] = 9 }",
        "Object.getPrototypeOf(Int32Array.prototype).fill = function () { this[1] = 9 }",
        "Number.isFinite = () => true",
        "Number = {}",
        "Reflect.apply = () => 0",
        "Function.prototype.call = null",
        "WeakMap.prototype.get = function () { this[1] = 9 }",
        "Array.prototype.includes = () => true",
        "Object.prototype.bounds = undefined",
        "[][Symbol.iterator]().__proto__.next = () => 0",
        "Math.min = 0",
        "data.ncon = 1000",
        "data.nefc = 1000",
        "data.efc_type[0] = 9",
        "model.nq = 1000",
        "class A extends Float64Array { get length() { return 4 } }\nmju_normalize4(new A(1))",
        "class A extends Float64Array {}\nObject.defineProperty(A.prototype, 'length', {value: "
        "4})\n"
        "mju_normalize4(new A(1))",
        "mju_mulQuat(data.qpos, data.qpos, data.qpos)",
        "mj_mulM(model, data, [1], [1])"}) {
    EXPECT_NE(run_error(attack), "no error") << attack;
    const int* now = simulation_.model()->jnt_qposadr;
    EXPECT_EQ(std::vector<int>(now, now + 4), before) << attack;
  }
  EXPECT_EQ(number("(forward(), data.qpos[0])"), 1);
}

// Its numbers are given twice: once to be looked at, once to be written.
TEST_F(StrictArrayTest, WritesWhatItHasLookedAt) {
  ASSERT_TRUE(
      world_.run("let asked = 0;\n"
                 "data.qvel.set({length: 1, get 0() { return asked++ ? NaN : 3 }})"));
  EXPECT_EQ(number("data.qvel[0]"), 3);
}

// What a script makes of an array is its own.
TEST_F(StrictArrayTest, CopiesAreTheScripts) {
  EXPECT_EQ(number("model.jnt_qposadr.slice().fill(9)[0] + model.jnt_qposadr.map((x) => 9)[1]"),
            18);
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
