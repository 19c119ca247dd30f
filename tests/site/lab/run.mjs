// A run does what plain steps of the simulation do, bit for bit.
//
//   node --test tests/site/lab/run.mjs

import assert from "node:assert/strict";
import { test } from "node:test";

import { lab, mjcfOf, newEngine, openRun } from "./run-harness.mjs";

const engine = await newEngine();
const plain = (mjcf) => engine.load("plain.xml", { "plain.xml": mjcf });

// All that can be read of mjData, the solver's warm start and the contacts with it.
function everything(simulation) {
  const { data } = simulation.world;
  const fields = Object.entries(data).filter(([, value]) => typeof value !== "object");
  const arrays = ["qpos", "qvel", "qacc", "qacc_warmstart", "xpos", "cvel", "qfrc_constraint"];
  return [...fields, ...arrays.map((name) => [name, ...data[name]]), [...simulation.state]];
}

const pushed = "data.qvel[3] = 0.5; data.qvel[4] = 1;";
const zoo = ({ run, write, value }) => ({
  controls: [
    { type: "button", label: "Spin", run: run(pushed) },
    {
      ...{
        type: "slider",
        label: "Gravity",
        bind: "model.opt.gravity[2]",
        min: -20,
        max: 0,
      },
      ...{ step: 0.1, value: null, digits: 1, unit: "m/s²" },
      ...{
        read: value("model.opt.gravity[2]"),
        write: write("model.opt.gravity[2]"),
      },
    },
    {
      ...{
        type: "slider",
        label: "Height",
        bind: "data.qpos[2]",
        min: 0,
        max: 2,
      },
      ...{ step: 0.1, value: 0.75, digits: 2, unit: "m" },
      ...{ read: value("data.qpos[2]"), write: write("data.qpos[2]") },
    },
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
  const simulation = plain(mjcfOf("joint_zoo"));
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
  const expected = plain(mjcf);
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

test("a ghost with another timestep keeps up", async () => {
  const run = await openRun(engine, mjcfOf("double_pendulum"), ({ run, value }) => ({
    controls: [{ type: "button", label: "Push", run: run("data.qvel[0] = 1") }],
    plots: [
      {
        ...{ ylabel: "rad", window: 5, ymin: null, ymax: null },
        traces: [{ label: "q", value: value("data.qpos[0]") }],
      },
    ],
    ghost: { label: "5 times the step", run: run("model.opt.timestep *= 5") },
  }));
  const { timestep } = run;
  run.operate(0, null);
  const ghost = plain(mjcfOf("double_pendulum"));
  ghost.world.model.opt.timestep *= 5;
  ghost.forward();
  ghost.world.data.qvel[0] = 1;
  ghost.forward();
  assert.equal(run.ghost.simulation.world.model.opt.timestep, ghost.world.model.opt.timestep);
  for (const [steps, ghosts] of [
    [2, 0],
    [1, 1],
    [4, 0],
    [1, 1],
    [492, 98],
  ]) {
    run.step(steps);
    ghost.step(ghosts);
    assert.ok(run.ghost.time >= run.time - 2.5 * timestep - 1e-12);
    assert.deepEqual(run.ghost.simulation.state, ghost.state);
  }
  const { times, traces } = run.samples[0].curves();
  assert.deepEqual(run.samples[0].labels, ["q", "q (5 times the step)"]);
  assert.equal(traces[1].filter((value) => value !== undefined).length, 101);
  assert.equal(times.length, traces[0].length);
  run.reset();
  run.step(3);
  assert.ok(Math.abs(run.ghost.time - 5 * timestep) < 1e-12);
  run.free();
});

test("a ghost that fails does not stop the run", async () => {
  const run = await openRun(engine, mjcfOf("slide"), ({ run }) => ({
    ghost: { label: "wild", run: run("data.qvel[0] = 1e300") },
  }));
  assert.equal(run.step(100), 100);
  assert.equal(run.trouble, undefined);
  assert.match(run.ghost.trouble.message, /diverged/);
  run.free();
});

test("trouble stops, says where it was, and is gone after a reset", async () => {
  const run = await openRun(engine, mjcfOf("slide"), ({ run, value }) => ({
    controls: [
      {
        type: "button",
        label: "Typo",
        run: run("const a = 1;\ndata.qpso[a] = 2;"),
      },
      { type: "button", label: "Burst", run: run("data.qvel[0] = 1e300") },
      {
        type: "button",
        label: "Step",
        run: run("data.qvel[0] = 1e300;\nstep(5);"),
      },
    ],
    readouts: [{ label: "x", value: value("data.qpos[1]"), digits: 2, unit: "m" }],
  }));
  run.operate(0, null);
  const { message, cure, source } = run.trouble;
  assert.deepEqual(
    { message, cure, source },
    {
      message: "data.qpso does not exist",
      cure: "did you mean `data.qpos`?",
      source: "const a = 1;\ndata.qpso[a] = 2;",
    },
  );
  assert.equal(run.step(5), 0);
  run.operate(1, null);
  assert.equal(run.trouble.message, message);
  run.reset();
  assert.equal(run.trouble, undefined);

  run.operate(1, null);
  assert.ok(run.step(100) < 100);
  assert.match(run.trouble.message, /^the simulation diverged/);
  assert.equal(run.trouble.source, "");
  run.reset();
  run.operate(2, null);
  assert.match(run.trouble.message, /^the simulation diverged/);
  assert.equal(run.trouble.source, "data.qvel[0] = 1e300;\nstep(5);");

  run.reset();
  assert.equal(run.printed(0), "–");
  assert.match(run.readingTrouble.message, /out of range 0\.\.0/);
  assert.equal(run.readingTrouble.source, "data.qpos[1]");
  assert.equal(run.step(10), 10);
  run.free();
});

test("a prediction is measured where it ends", async () => {
  const run = await openRun(engine, mjcfOf("free"), ({ run, value }) => ({
    predict: {
      ...{
        question: "",
        run: run("data.qvel[2] = 3"),
        seconds: 0.5,
        value: value("data.qpos[2]"),
      },
      ...{ digits: 2, unit: "m", tolerance: 0.1, explanation: "" },
    },
  }));
  run.step(30);
  run.predict();
  assert.equal(run.time, 0);
  assert.ok(run.predicting);
  const steps = Math.round(0.5 / run.timestep);
  assert.equal(run.step(10 * steps), steps);
  assert.ok(!run.predicting);
  const expected = plain(mjcfOf("free"));
  expected.world.data.qvel[2] = 3;
  expected.forward();
  expected.step(steps);
  assert.equal(run.measured, expected.world.data.qpos[2]);
  assert.equal(run.step(5), 5);
  run.reset();
  assert.equal(run.measured, undefined);
  run.free();
});

test("a goal once reached stays reached", async () => {
  const run = await openRun(engine, mjcfOf("free"), ({ value }) => ({
    goal: { text: "", done: value("data.time > 0.1") },
    editable: {
      tasks: [{ question: "", value: value("model.nv"), tolerance: 0, unit: "" }],
    },
  }));
  assert.ok(!run.goalReached && !run.tasksOpen);
  run.step(500);
  assert.ok(run.goalReached && run.tasksOpen);
  run.reset();
  assert.ok(run.goalReached);
  assert.equal(run.judgeTask(0, 6), true);
  assert.equal(run.judgeTask(0, 7), false);
  run.free();
});

test("an edited model starts anew, one with an error changes nothing", async () => {
  const mjcf = mjcfOf("slide");
  const run = await openRun(engine, mjcf, ({ value }) => ({
    readouts: [{ label: "v", value: value("data.qvel[0]"), digits: 2, unit: "" }],
  }));
  run.stage.camera = { ...run.stage.camera, azimuth: 33 };
  run.stage.showOverlay("joints", true);
  run.step(50);
  const { state } = run.simulation;
  const error = run.recompile(mjcf.replace("<geom", "<geom sizze='1'"));
  assert.ok(error instanceof lab.LoadError);
  assert.match(error.message, /sizze/);
  assert.deepEqual([error.line, error.cure], [5, "did you mean `size`?"]);
  assert.deepEqual(run.simulation.state, state);
  assert.equal(run.mjcf, mjcf);
  run.step(1);

  const scene = run.scene;
  assert.equal(run.recompile(mjcfOf("stacked_boxes")), undefined);
  assert.equal(run.time, 0);
  assert.notEqual(run.scene, scene);
  assert.equal(run.stage.camera.azimuth, 33);
  assert.ok(run.stage.overlays.has("joints"));
  run.step(100);
  const expected = plain(mjcfOf("stacked_boxes"));
  expected.step(100);
  assert.deepEqual(run.simulation.state, expected.state);
  run.free();
});

test("fifty models come and go in the same memory", async () => {
  const young = await newEngine();
  const run = await openRun(young, mjcfOf("stacked_boxes"), ({ run }) => ({
    ghost: { label: "slow", run: run("model.opt.timestep *= 2") },
  }));
  const buffers = new Set();
  for (let i = 0; i < 50; i++) {
    run.stage.update();
    run.step(5);
    assert.ok(run.recompile("<mujoco><worldbody><geom/></worldbody></mujoco>"));
    assert.equal(run.recompile(mjcfOf(i % 2 ? "stacked_boxes" : "free")), undefined);
    buffers.add(run.simulation.world.data.qpos.buffer);
    if (i === 10) buffers.clear();
  }
  assert.equal(buffers.size, 1);
  run.free();
});

test("a hand pulls, and its force goes with it", async () => {
  const run = await openRun(engine, mjcfOf("free"), ({ run }) => ({
    ghost: { label: "same", run: run("model.opt.timestep *= 1") },
  }));
  const { stage } = run;
  const body = stage.select(1, 0.5, 0.5);
  const push = () => [...run.simulation.world.data.xfrc_applied];
  assert.equal(body, 0, "nothing is seen where the lab does not look");
  stage.camera = {
    azimuth: 90,
    elevation: 0,
    distance: 1,
    target: bodyPlace(run, 1),
  };
  stage.update();
  assert.equal(stage.select(1, 0.5, 0.5), 1);
  run.hold("pull");
  stage.drag("moveVertical", 0.2, 0);
  run.step(1);
  assert.ok(push().some((value) => value !== 0));
  assert.deepEqual([...run.ghost.simulation.world.data.xfrc_applied], push());
  run.keep();
  run.hold("none");
  assert.ok(push().every((value) => value === 0));
  assert.ok(run.ghost.simulation.world.data.xfrc_applied.every((value) => value === 0));
  run.step(10);
  run.keep();
  // the past has the force, what goes on from there has not
  run.seek(1);
  assert.ok(push().some((value) => value !== 0));
  run.step(1);
  assert.ok(push().every((value) => value === 0));
  run.free();
});

function bodyPlace(run, body) {
  return [...run.simulation.world.data.xpos.slice(3 * body, 3 * body + 3)];
}
