// A simulation in the engine: its world, its state, its errors, its memory.
//
//   node --test tests/engine/simulation.mjs

import assert from "node:assert/strict";
import path from "node:path";
import { test } from "node:test";

import { load, models, newEngine } from "./harness.mjs";

const engine = await newEngine();
const open = (name) => load(engine, path.join(models, `${name}.xml`));

// Megabytes of padding that a model asks for.
const heavy = (megabytes) =>
  `<mujoco><size nstack="${megabytes * 131072}"/><worldbody><body><freejoint/><geom size="1"/></body></worldbody></mujoco>`;

test("the world is the strict one", () => {
  const simulation = open("slide");
  const { data, model, qpos, ctrl } = simulation.world;
  assert.equal(model.nq, 1);
  assert.throws(() => data.qpso, /data\.qpso does not exist/);
  assert.throws(() => data.qpos[1], /data\.qpos\[1\] is out of range 0\.\.0/);
  assert.throws(() => (data.qpos[0] = NaN), /not a finite number/);
  qpos("slide")[0] = 0.5;
  assert.equal(data.qpos[0], 0.5);
  assert.throws(() => ctrl("motr"), /no actuator is named `motr`/);
  simulation.free();
});

test("MuJoCo's functions work on its memory and on plain arrays", () => {
  const simulation = open("ball");
  const { world } = simulation;
  const quat = [0, 0, 0, 2];
  assert.equal(world.mju_normalize4(quat), 2);
  assert.deepEqual(quat, [0, 0, 0, 1]);
  world.data.qpos.set([0, 3, 0, 0]);
  world.mju_normalize4(world.data.qpos);
  assert.deepEqual([...world.data.qpos], [0, 1, 0, 0]);
  const velocity = [0, 0, 0];
  world.mj_differentiatePos(world.model, velocity, 1, [1, 0, 0, 0], [0, 1, 0, 0]);
  assert.ok(Math.abs(velocity[0] - Math.PI) < 1e-12);
  simulation.free();
});

test("a state that is put back goes on with the same bits", () => {
  const simulation = open("stacked_boxes");
  simulation.step(300);
  const kept = simulation.state;
  simulation.step(300);
  const end = simulation.state;
  simulation.reset();
  simulation.state = kept;
  simulation.step(300);
  assert.deepEqual(simulation.state, end);
  assert.throws(() => (simulation.state = kept.subarray(1)), RangeError);
  simulation.free();
});

test("a keyframe", () => {
  const simulation = open("free");
  simulation.resetToKeyframe(0);
  assert.equal(simulation.world.data.qvel[2], 3);
  assert.throws(() => simulation.resetToKeyframe(1), /there is no keyframe 1; the model has 1/);
  simulation.free();
});

test("what diverges stops, and a reset starts anew", () => {
  const simulation = open("slide");
  simulation.world.data.qvel[0] = 1e300;
  const diverged = {
    id: "E-script-mujoco",
    message: /the simulation diverged.*qvel\[0\] of joint `slide`/,
  };
  assert.throws(() => simulation.world.step(), diverged);
  assert.throws(() => simulation.step(), diverged);
  simulation.reset();
  simulation.step(100);
  assert.equal(simulation.trouble, "");
  simulation.free();
});

test("an error of MuJoCo's is caught, and the engine works on", () => {
  // room enough to fly, not to land
  const starved = `<mujoco><size nstack="200"/><worldbody><geom type="plane" size="1 1 1"/>
    <body pos="0 0 1"><freejoint/><geom type="box" size=".1 .1 .1"/></body></worldbody></mujoco>`;
  const simulation = engine.load("box.xml", { "box.xml": starved });
  const stopped = {
    id: "E-script-mujoco",
    message: /^MuJoCo gave up at t = [\d.]+ s: Stack overflow$/,
  };
  for (let i = 0; i < 20; i++) {
    simulation.reset();
    assert.throws(() => simulation.step(1000), stopped);
  }
  simulation.reset();
  simulation.step(100);
  simulation.free();
});

test("so is one that a function raises, and the stack is as before", () => {
  const simulation = open("free");
  const { mj_objectVelocity } = simulation.native().functions;
  const glue = simulation.memory.glue;
  const stack = glue.stackSave();
  for (let i = 0; i < 1000; i++) {
    assert.throws(() => mj_objectVelocity(99, 0, new Float64Array(6), 0), {
      id: "E-script-mujoco",
      message: /object type/,
    });
  }
  assert.equal(glue.stackSave(), stack);
  simulation.step(100);
  simulation.free();
});

test("a world survives that memory grows", async () => {
  const young = await newEngine();
  const simulation = load(young, path.join(models, "free.xml"));
  const before = simulation.world;
  simulation.step(10);
  const { state } = simulation;
  const other = young.load("heavy.xml", { "heavy.xml": heavy(60) });
  const after = simulation.world;
  assert.notEqual(after, before);
  assert.equal(simulation.world, after);
  assert.throws(() => before.data.qpos[0], /data\.qpos is empty/);
  assert.deepEqual(simulation.state, state);
  assert.equal(after.data.qpos[2], state[3]);
  other.free();
  simulation.free();
});

test("200 models come and go in the same memory", async () => {
  const young = await newEngine();
  const buffers = new Set();
  for (let i = 0; i < 200; i++) {
    const simulation = load(young, path.join(models, "mesh.xml"), ["wedge.obj"]);
    simulation.openScene().update();
    simulation.step(5);
    assert.ok(simulation.world);
    buffers.add(simulation.opened.buffer);
    if (i === 10) buffers.clear();
    simulation.free();
  }
  assert.equal(buffers.size, 1);
});

test("a simulation that was freed says so", () => {
  const simulation = open("free");
  simulation.free();
  simulation.free();
  assert.throws(() => simulation.step(), /this simulation was freed/);
  assert.throws(() => simulation.world, /this simulation was freed/);
});
