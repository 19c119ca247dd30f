// Models load in the engine, and wrong ones say what is wrong at which line, in the words of a build.
//
//   node --test tests/engine/load.mjs

import assert from "node:assert/strict";
import { test } from "node:test";

import { newEngine } from "./harness.mjs";

const engine = await newEngine();

function refusal(files, name = "arm.xml") {
  try {
    engine.load(name, files).free();
  } catch (error) {
    const { file, line, column, message, cure } = error;
    return { file, line, column, message, cure };
  }
  return "no error";
}

test("a misspelt attribute has its line and a cure", () => {
  const mjcf = "<mujoco>\n<worldbody>\n  <geom sizee='1'/>\n</worldbody>\n</mujoco>";
  assert.deepEqual(refusal({ "arm.xml": mjcf }), {
    file: "arm.xml",
    line: 3,
    column: 0,
    message: "element 'geom': unrecognized attribute: 'sizee'",
    cure: "did you mean `size`?",
  });
});

test("XML that is not well-formed has its line", () => {
  const { line, message } = refusal({
    "arm.xml": "<mujoco>\n<worldbody>\n</mujoco>",
  });
  assert.equal(line, 2);
  assert.match(message, /^not well-formed XML: mismatched element/);
});

test("what the compiler refuses has its line", () => {
  const mjcf = "<mujoco><worldbody>\n<body name='b'>\n<freejoint/></body></worldbody></mujoco>";
  const { line, message } = refusal({ "arm.xml": mjcf });
  assert.deepEqual(
    [line, message],
    [2, "object 'b': mass and inertia of moving bodies must be larger than mjMINVAL"],
  );
});

test("a mistake in an included file is placed there", () => {
  const files = {
    "arm.xml": "<mujoco>\n<include file='hand.xml'/></mujoco>",
    "hand.xml": "<mujoco>\n<a>",
  };
  const { file, line } = refusal(files);
  assert.deepEqual([file, line], ["hand.xml", 2]);
});

test("missing and empty files are errors", () => {
  assert.equal(refusal({}).message, "file not found");
  assert.deepEqual(refusal({ "arm.xml": "" }).message, "the file is empty");
  const mesh = "<mujoco><asset><mesh file='gone.stl'/></asset></mujoco>";
  assert.match(refusal({ "arm.xml": mesh }).message, /gone\.stl/);
});

test("after every error the engine loads and steps", () => {
  const mjcf = "<mujoco><worldbody><body><freejoint/><geom size='1'/></body></worldbody></mujoco>";
  const simulation = engine.load("ball.xml", { "ball.xml": mjcf });
  simulation.step(10);
  assert.ok(simulation.world.data.qpos[2] < 0);
  simulation.free();
});

test("warnings of the compiler are kept", () => {
  const mjcf = `<mujoco><size njmax="2" nconmax="1"/><worldbody><geom type="plane" size="1 1 1"/>
    <body pos="0 0 0.09"><freejoint/><geom type="box" size=".1 .1 .1"/></body></worldbody></mujoco>`;
  const simulation = engine.load("box.xml", { "box.xml": mjcf });
  assert.equal(simulation.warnings.length, 1);
  assert.match(simulation.warnings[0], /Increase njmax above 2/);
  simulation.free();
});
