#include "script/world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "world_fixture.h"

namespace mjcourse {

TEST_F(WorldTest, GivesSizesAndSettings) {
  EXPECT_EQ(number("model.nq"), 13);
  EXPECT_EQ(number("model.nv"), 11);
  EXPECT_EQ(number("model.opt.timestep"), 0.002);
  EXPECT_EQ(number("model.opt.gravity[2]"), -10);
  EXPECT_EQ(number("model.vis.global.fovy"), 45);
  EXPECT_EQ(number("model.stat.extent"), simulation_.model()->stat.extent);
}

TEST_F(WorldTest, SeesTheSimulationMove) {
  EXPECT_EQ(number("data.time"), 0);
  simulation_.step(5);
  EXPECT_DOUBLE_EQ(number("data.time"), 0.01);
  EXPECT_EQ(number("data.qpos[2]"), simulation_.data()->qpos[2]);
  EXPECT_LT(number("data.qpos[2]"), 3);
}

TEST_F(WorldTest, WritesIntoMujocosOwnMemory) {
  ASSERT_TRUE(world_.run("data.qvel[3] = 0.5; model.opt.timestep = 0.004; data.time = 7"));
  EXPECT_EQ(simulation_.data()->qvel[3], 0.5);
  EXPECT_EQ(simulation_.model()->opt.timestep, 0.004);
  EXPECT_EQ(simulation_.data()->time, 7);
}

TEST_F(WorldTest, StepsForwardsAndResets) {
  ASSERT_TRUE(world_.run("step(); step(4)"));
  EXPECT_DOUBLE_EQ(simulation_.data()->time, 0.01);
  ASSERT_TRUE(world_.run("qpos('free')[0] = 9; forward()"));
  EXPECT_EQ(number("body('box').xpos[0]"), 9);
  ASSERT_TRUE(world_.run("reset()"));
  EXPECT_EQ(number("data.time + qpos('free')[0]"), 1);
}

TEST_F(WorldTest, PassesTimeBetweenAScriptAndItsValue) {
  const auto fallen = world_.number(
      Program{"const before = data.qpos[2]  // no semicolon", 0.1, "before - data.qpos[2]"});
  ASSERT_TRUE(fallen) << shown(fallen.error());
  EXPECT_NEAR(*fallen, 0.5 * 10 * 0.1 * 0.1, 0.002);
  const auto held = world_.truth(Program{"let x = 1; x += 1", 0, "x === 2"});
  ASSERT_TRUE(held) << shown(held.error());
  EXPECT_TRUE(*held);
}

TEST_F(WorldTest, AssignsToWhatTheAuthorNames) {
  ASSERT_TRUE(world_.assign("data.ctrl[0]", 0.5));
  EXPECT_EQ(simulation_.data()->ctrl[0], 0.5);
  ASSERT_TRUE(world_.assign("ctrl('motor')[0] // the only one", -2));
  EXPECT_EQ(simulation_.data()->ctrl[0], -2);
  ASSERT_TRUE(world_.assign("model.opt.gravity[\n2\n]", -1));
  EXPECT_EQ(simulation_.model()->opt.gravity[2], -1);
}

TEST_F(WorldTest, AssignsToNothingElse) {
  const auto assign_error = [&](const std::string& target, double value = 1) {
    const auto done = world_.assign(target, value);
    return done ? "no error" : shown(done.error());
  };
  for (const std::string target :
       {"1 + 1", "data.time = 3", "data.time = 3, data.time", "f()", "data.time) + (1"}) {
    EXPECT_EQ(assign_error(target),
              "E-script-syntax 1:1+" + std::to_string(target.size()) +
                  " this cannot be assigned to | name one number: data.ctrl[0], "
                  "model.opt.gravity[2]");
  }
  EXPECT_EQ(assign_error("data.time; data.time"),
            "E-script-syntax 1:10+1 Unexpected token ';'. Expected ')' to end a compound "
            "expression. | look for a missing bracket, quote or operator just before this");
  EXPECT_EQ(assign_error("data.crtl[0]"),
            "E-script-name 1:6+4 data.crtl does not exist | did you mean `data.ctrl`?");
  EXPECT_EQ(assign_error("data.qpos[99]"),
            "E-script-range 1:1+13 data.qpos[99] is out of range 0..12 | ");
  EXPECT_EQ(assign_error("data.qpos"),
            "E-script-value 1:1+9 data.qpos cannot be assigned | it is an array: data.qpos[0] = "
            "…, or data.qpos.set([…])");
  EXPECT_EQ(assign_error("model.nq"),
            "E-script-value 1:1+8 model.nq cannot be assigned | MuJoCo computes it from the model");
  EXPECT_EQ(assign_error("model.opt.iterations", 0.5),
            "E-script-value 1:1+20 model.opt.iterations = 0.5: not a whole number | ");
}

TEST_F(WorldTest, TellsItsNames) {
  const std::vector<std::string>& names = world_.names();
  for (const std::string name : {"data", "model", "qpos", "step", "Math", "mj_step"}) {
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  }
}

TEST_F(WorldTest, GivesTextsAndArraysAsJson) {
  EXPECT_EQ(world_.value("[model.nq, model.nq > 3, 'x']").value(),
            nlohmann::json::parse(R"([13, true, "x"])"));
  EXPECT_EQ(world_.value("qpos('free').slice(0, 3)").value(), nlohmann::json({1.0, 2.0, 3.0}));
  EXPECT_EQ(
      shown(world_.value("({a: 1})").error()),
      "E-script-value 1:1+8 the value is an object, not a number, a text or an array of these | ");
}

TEST_F(WorldTest, MakesCharactersWhole) {
  EXPECT_EQ(world_.value("['😀', '😀'.slice(0, 1), '\\\\ud83d', '😀😀'.slice(1)]").value(),
            nlohmann::json({"😀", "\uFFFD", "\\ud83d", "\uFFFD😀"}));
  EXPECT_EQ(shown(world_.run("throw Error('😀'.slice(1))").error()),
            "E-script-throw 1:7+5 \uFFFD | ");
}

TEST_F(WorldTest, MathRepeatsInEveryWorld) {
  Simulation other = simulate(robot);
  World second(bundle("world"), other);
  const double first = number("Math.random()");
  EXPECT_EQ(second.number("Math.random()").value(), first);
  EXPECT_NE(number("Math.random()"), first);
  EXPECT_EQ(number("Math.hypot(3, 4)"), 5);
  EXPECT_EQ(value_error("Math.hypto(3, 4)"),
            "E-script-name 1:6+5 Math.hypto does not exist | did you mean `Math.hypot`?");
}

TEST_F(WorldTest, HasMujocosConstants) {
  EXPECT_EQ(number("mjOBJ_BODY"), mjOBJ_BODY);
  EXPECT_EQ(number("mjOBJ_XBODY"), mjOBJ_XBODY);
  EXPECT_EQ(number("mjOBJ_JOINT"), mjOBJ_JOINT);
  EXPECT_EQ(number("mjOBJ_GEOM"), mjOBJ_GEOM);
  EXPECT_EQ(number("mjOBJ_SITE"), mjOBJ_SITE);
  EXPECT_EQ(number("mjOBJ_CAMERA"), mjOBJ_CAMERA);
  EXPECT_EQ(number("mjOBJ_ACTUATOR"), mjOBJ_ACTUATOR);
  EXPECT_EQ(number("mjOBJ_SENSOR"), mjOBJ_SENSOR);
  EXPECT_EQ(number("mjJNT_FREE"), mjJNT_FREE);
  EXPECT_EQ(number("mjJNT_BALL"), mjJNT_BALL);
  EXPECT_EQ(number("mjJNT_SLIDE"), mjJNT_SLIDE);
  EXPECT_EQ(number("mjJNT_HINGE"), mjJNT_HINGE);
  EXPECT_EQ(number("mjGEOM_PLANE"), mjGEOM_PLANE);
  EXPECT_EQ(number("mjGEOM_HFIELD"), mjGEOM_HFIELD);
  EXPECT_EQ(number("mjGEOM_SPHERE"), mjGEOM_SPHERE);
  EXPECT_EQ(number("mjGEOM_CAPSULE"), mjGEOM_CAPSULE);
  EXPECT_EQ(number("mjGEOM_ELLIPSOID"), mjGEOM_ELLIPSOID);
  EXPECT_EQ(number("mjGEOM_CYLINDER"), mjGEOM_CYLINDER);
  EXPECT_EQ(number("mjGEOM_BOX"), mjGEOM_BOX);
  EXPECT_EQ(number("mjGEOM_MESH"), mjGEOM_MESH);
}

// What ends a script, by the parts of a message: id, line:column+width, words, cure.

TEST_F(WorldTest, SyntaxIsPlacedInTheAuthorsText) {
  EXPECT_EQ(
      run_error("let a = 1;\nlet b = (2;"),
      "E-script-syntax 2:11+1 Unexpected token ';'. Expected ')' to end a compound expression. | "
      "look for a missing bracket, quote or operator just before this");
  EXPECT_EQ(value_error("1 +"),
            "E-script-syntax 1:4+1 the script ends too early: Unexpected token ')' | look for a "
            "missing bracket, quote or operator just before this");
  EXPECT_EQ(run_error("a = 1; }\n"),
            "E-script-syntax 1:1+8 a closing bracket has no opening one | remove it, or open it");
  EXPECT_EQ(run_error("}); (function () {"),
            "E-script-syntax 1:1+18 a closing bracket has no opening one | remove it, or open it");
}

TEST_F(WorldTest, UnknownNamesAreNamed) {
  EXPECT_EQ(run_error("let x = data.qpos[0];\n  x += data.qpso[0];"),
            "E-script-name 2:13+4 data.qpso does not exist | did you mean `data.qpos`?");
  EXPECT_EQ(run_error("data.qpso = 1"),
            "E-script-name 1:6+4 data.qpso does not exist | did you mean `data.qpos`?");
  EXPECT_EQ(value_error("model.opt.timestepp"),
            "E-script-name 1:11+9 model.opt.timestepp does not exist | did you mean "
            "`model.opt.timestep`?");
  EXPECT_EQ(value_error("1 + qpso('hinge')[0]"),
            "E-script-name 1:5+4 `qpso` does not exist | did you mean `qpos`?");
  EXPECT_EQ(value_error("Date.now()"),
            "E-script-name 1:1+4 `Date` does not exist | did you mean `data`?");
  EXPECT_EQ(run_error("foo = 3"),
            "E-script-name 1:1+3 `foo` does not exist | known: model, data, Math, qpos, qvel, "
            "body, geom, "
            "site, joint, sensor, ctrl, step, …");
}

TEST_F(WorldTest, IndicesStayInRange) {
  EXPECT_EQ(value_error("data.qpos[0] + data.qpos[13]"),
            "E-script-range 1:16+13 data.qpos[13] is out of range 0..12 | ");
  EXPECT_EQ(run_error("for (let i = 0; i <= model.nv; i++) data.qvel[i] = 0;"),
            "E-script-range 1:37+9 data.qvel[11] is out of range 0..10 | ");
  EXPECT_EQ(value_error("data.act[0]"),
            "E-script-range 1:1+11 data.act[0] does not exist: data.act is empty | ");
}

TEST_F(WorldTest, WritesAreFiniteNumbers) {
  EXPECT_EQ(
      run_error("data.qvel[3] = NaN"),
      "E-script-value 1:1+12 data.qvel[3] = NaN: not a finite number | look for a division by "
      "0, or a root or a logarithm of a negative number");
  EXPECT_EQ(run_error("data.qvel[3] = 'fast'"),
            "E-script-value 1:1+12 data.qvel[3] = \"fast\": not a number | ");
  EXPECT_EQ(run_error("model.opt.timestep = 1 / 0"),
            "E-script-value 1:1+18 model.opt.timestep = Infinity: not a finite number | look for a "
            "division by 0, or a root or a logarithm of a negative number");
  EXPECT_EQ(run_error("model.nq = 3"),
            "E-script-value 1:1+8 model.nq cannot be assigned | MuJoCo computes it from the model");
  EXPECT_EQ(
      run_error("data.qpos = [1]"),
      "E-script-value 1:1+9 data.qpos cannot be assigned | it is an array: data.qpos[0] = …, or "
      "data.qpos.set([…])");
  EXPECT_EQ(run_error("model = 3"),
            "E-script-value 1:1+5 model cannot be assigned | assign its fields one by one: "
            "model.opt.timestep = …");
  EXPECT_EQ(run_error("data = model"),
            "E-script-value 1:1+4 data cannot be assigned | assign its fields one by one: "
            "data.ctrl[0] = …");
  EXPECT_EQ(simulation_.data()->qvel[3], 0);
}

TEST_F(WorldTest, ResultsHaveTheTypeAskedFor) {
  EXPECT_EQ(
      value_error("0 / 0"),
      "E-script-value 1:1+5 the value is NaN, not a finite number | look for a division by 0, or a "
      "root or a logarithm of a negative number");
  EXPECT_EQ(value_error("  'abc'"), "E-script-value 1:3+5 the value is \"abc\", not a number | ");
  EXPECT_EQ(value_error("qpos('free')"),
            "E-script-value 1:1+12 the value is an array of length 7, not a number | ");
  EXPECT_EQ(number("qpos('hinge')"), 0);
  EXPECT_EQ(shown(world_.truth("1").error()),
            "E-script-value 1:1+1 the value is 1, not true or false | ");
}

TEST_F(WorldTest, EndlessLoopsEndAndTheWorldGoesOn) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(run_error("try { while (true); } catch { data.qvel[0] = 1 }"),
              "E-script-time 0:0+1 ran for more than 0.2 s | look for a loop that never ends");
    EXPECT_EQ(run_error("step(1e9)"),
              "E-script-time 0:0+1 ran for more than 0.2 s | look for a loop that never ends");
    EXPECT_EQ(number("model.nq + data.qvel[0]"), 13);
  }
}

TEST_F(WorldTest, ThrownErrorsKeepTheirPlace) {
  EXPECT_EQ(run_error("\nthrow new Error('no luck')"), "E-script-throw 2:11+5 no luck | ");
  EXPECT_EQ(run_error("throw 'a word'"), "E-script-throw 0:0+1 a word | ");
  EXPECT_EQ(run_error("const s = {}; // é𝄞\n/* é𝄞 */ s.run()"),
            "E-script-throw 2:10+7 TypeError: s.run is not a function. (In 's.run()', 's.run' is "
            "undefined) | ");
}

TEST_F(WorldTest, WhatAScriptThrowsSaysNothingThatIsNotSo) {
  const auto thrown = [&](const std::string& more) {
    return run_error("throw Object.assign(new Error('no luck'), {" + more + "})");
  };
  const std::string here = thrown("");
  EXPECT_EQ(here, "E-script-throw 1:25+5 no luck | ");
  EXPECT_EQ(thrown("id: 'E-made-up\\x1b', cure: 'x'"), here);
  EXPECT_EQ(thrown("tokens: {length: 4294967295}"), here);
  EXPECT_EQ(thrown("tokens: {}"), here);
  // The stack is its own, too.
  EXPECT_EQ(thrown("stack: '@lesson.js:99999999999:-5'"), "E-script-throw 1:1+79 no luck | ");
}

TEST_F(WorldTest, MujocosTroubleEndsTheScript) {
  EXPECT_EQ(
      run_error("data.qvel[0] = 1e11;\nstep(10)"),
      "E-script-mujoco 2:1+4 the simulation diverged at t = 0.002 s: qvel[0] of joint `free` is "
      "infinite, not a number, or huge | ");
  EXPECT_EQ(
      run_error("step()"),
      "E-script-mujoco 1:1+4 the simulation diverged at t = 0.002 s: qvel[0] of joint `free` is "
      "infinite, not a number, or huge | ");
  ASSERT_TRUE(world_.run("reset(); step()"));
  const auto later = world_.number(Program{"data.qvel[0] = 1e11", 1, "data.time"});
  ASSERT_FALSE(later);
  EXPECT_EQ(
      shown(later.error()),
      "E-script-mujoco 0:0+1 the simulation diverged at t = 0.002 s: qvel[0] of joint `free` is "
      "infinite, not a number, or huge | ");
}

TEST_F(WorldTest, TellsWhetherScriptOrValueIsWrong) {
  const auto in_script = world_.number(Program{"let a = 1;\ndata.x", 0, "a"});
  EXPECT_EQ(shown(in_script.error()), "E-script-name 2:6+1 data.x does not exist | ");
  EXPECT_FALSE(in_script.error().in_value);
  const auto in_value = world_.number(Program{"let a = 1;\na += 1", 0, "a +\n  data.x"});
  EXPECT_EQ(shown(in_value.error()), "E-script-name 2:8+1 data.x does not exist | ");
  EXPECT_TRUE(in_value.error().in_value);
  const auto called = world_.number(Program{"let f = () => { data.x };", 0, "f() + 1"});
  EXPECT_EQ(shown(called.error()), "E-script-name 1:22+1 data.x does not exist | ");
  EXPECT_FALSE(called.error().in_value);
}

}  // namespace mjcourse
