// A run does what plain steps of the simulation do, bit for bit.
//
//   node --test tests/site/lab/run.mjs

import assert from "node:assert/strict";
import { test } from "node:test";

import { gravitySlider, mjcfOf, newEngine, openPlain, openRun, slider } from "./run-harness.mjs";

const engine = await newEngine();

// All that can be read of mjData, the solver's warm start and the contacts with it.
function everything(simulation) {
  const { data } = simulation.world;
  const fields = Object.entries(data).filter(([, value]) => typeof value !== "object");
  const arrays = ["qpos", "qvel", "qacc", "qacc_warmstart", "xpos", "cvel", "qfrc_constraint"];
  return [...fields, ...arrays.map((name) => [name, ...data[name]]), [...simulation.state]];
}

const pushed = "data.qvel[3] = 0.5; data.qvel[4] = 1;";
const zoo = ({ run, value, write }) => ({
  controls: [
    { type: "button", label: "Spin", run: run(pushed) },
    gravitySlider({ value, write }),
    slider(
      { value, write },
      {
        ...{ label: "Height", bind: "data.qpos[2]", min: 0, max: 2 },
        ...{ value: 0.75, digits: 2, unit: "m" },
      },
    ),
    {
      ...{ type: "toggle", label: "Turn", value: true },
      ...{ on: run("data.qvel[10] = 2"), off: run("data.qvel[10] = 0") },
    },
    {
      ...{ type: "select", label: "Slide", value: null },
      options: [
        { label: "up", run: run("data.qvel[9] = 0.2") },
        { label: "down", run: run("data.qvel[9] = -0.2") },
      ],
    },
  ],
  readouts: [
    { label: "nq", value: value("model.nq"), digits: 0, unit: "" },
    {
      label: "|q|",
      value: value("Math.hypot(...data.qpos.slice(3, 7))"),
      digits: 12,
      unit: "",
    },
    { label: "height", value: value("data.xpos[5]"), digits: 4, unit: "m" },
  ],
});

// The zoo's start and a control's script on a plain simulation.
function plainZoo(script = () => undefined) {
  const simulation = openPlain(engine, mjcfOf("joint_zoo"));
  const { data } = simulation.world;
  data.qpos[2] = 0.75;
  data.qvel[10] = 2;
  simulation.forward();
  script(simulation.world);
  simulation.forward();
  return simulation;
}

test("a reset, a control and steps give the bits of a plain simulation", async () => {
  const run = await openRun(engine, mjcfOf("joint_zoo"), zoo);
  for (let i = 0; i < 2; i++) {
    const expected = plainZoo(({ data }) => {
      data.qvel[3] = 0.5;
      data.qvel[4] = 1;
    });
    run.operate(0, null);
    assert.deepEqual(everything(run.simulation), everything(expected));
    run.step(250);
    expected.step(250);
    assert.deepEqual(everything(run.simulation), everything(expected));
    run.reset();
    assert.equal(run.time, 0);
    expected.free();
  }
  run.free();
});

test("a reset puts the model back too", async () => {
  const run = await openRun(engine, mjcfOf("joint_zoo"), zoo);
  assert.equal(run.settings[1], 0);
  run.operate(1, -9.81);
  assert.equal(run.settings[1], -9.81);
  run.step(100);
  run.reset();
  assert.equal(run.settings[1], 0);
  run.step(100);
  const expected = plainZoo();
  expected.step(100);
  assert.deepEqual(run.simulation.state, expected.state);
  run.free();
});

test("controls have their values", async () => {
  const run = await openRun(engine, mjcfOf("joint_zoo"), zoo);
  const { data } = run.simulation.world;
  assert.deepEqual(run.settings, [null, 0, 0.75, true, null]);
  run.operate(3, false);
  assert.equal(data.qvel[10], 0);
  run.operate(4, 1);
  assert.equal(data.qvel[9], -0.2);
  data.qpos[2] = 0.5;
  assert.deepEqual(run.settings, [null, 0, 0.5, false, 1]);
  run.reset();
  assert.deepEqual(run.settings, [null, 0, 0.75, true, null]);
  assert.deepEqual([data.qvel[9], data.qvel[10]], [0, 2]);
  run.free();
});

test("readouts are printed as in the build", async () => {
  const run = await openRun(engine, mjcfOf("joint_zoo"), zoo);
  run.operate(0, null);
  run.step(250);
  assert.equal(run.readingTrouble, undefined);
  assert.deepEqual(
    [0, 1, 2].map((i) => run.printed(i)),
    ["13", "1.000000000000", "0.7500"],
  );
  run.free();
});

test("a keyframe, in a model whose bodies touch", async () => {
  const mjcf = mjcfOf("pick_place");
  const run = await openRun(engine, mjcf, ({ value }) => ({
    controls: [{ type: "keyframe", label: "reach", key: 1 }],
    plots: [
      {
        ...{ ylabel: "m", window: 5, ymin: null, ymax: null },
        traces: [{ label: "height", value: value("body('cube').xpos[2]") }],
      },
    ],
  }));
  const expected = openPlain(engine, mjcf);
  for (const each of [run, expected]) each.step(50);
  assert.deepEqual(everything(run.simulation), everything(expected));
  run.operate(0, null);
  expected.resetToKeyframe(1);
  expected.forward();
  run.step(200);
  expected.step(200);
  assert.ok(run.simulation.world.data.ncon > 0);
  assert.deepEqual(everything(run.simulation), everything(expected));
  // time began anew, and so did what is kept
  assert.equal(run.samples[0].curves().times.length, 201);
  assert.equal(run.history.length, 1);
  run.free();
});

test("Math.random() is the same in each run", async () => {
  const run = await openRun(engine, mjcfOf("slide"), ({ run }) => ({
    controls: [
      {
        type: "button",
        label: "Toss",
        run: run("data.qvel[0] = Math.random()"),
      },
    ],
  }));
  const toss = () => {
    run.operate(0, null);
    return run.simulation.world.data.qvel[0];
  };
  const first = [toss(), toss()];
  assert.notEqual(first[0], first[1]);
  run.reset();
  assert.deepEqual([toss(), toss()], first);
  run.free();
});
