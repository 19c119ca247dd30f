// A model that the reader edits.
//
//   node --test tests/site/lab/run-edited.mjs

import assert from "node:assert/strict";
import { test } from "node:test";

import { lab, mjcfOf, newEngine, openPlain, openRun } from "./run-harness.mjs";

const engine = await newEngine();

test("an edited model starts anew, one with an error changes nothing", async () => {
  const mjcf = mjcfOf("slide");
  const run = await openRun(engine, mjcf, ({ value }) => ({
    readouts: [{ label: "v", value: value("data.qvel[0]"), digits: 2, unit: "" }],
  }));
  run.visualization.camera = { ...run.visualization.camera, azimuth: 33 };
  run.visualization.showOverlay("joints", true);
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
  assert.equal(run.visualization.camera.azimuth, 33);
  assert.ok(run.visualization.overlays.has("joints"));
  run.step(100);
  const expected = openPlain(engine, mjcfOf("stacked_boxes"));
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
  for (let i = 0; i < 80; i++) {
    run.visualization.update();
    run.step(5);
    assert.ok(run.recompile("<mujoco><worldbody><geom/></worldbody></mujoco>"));
    assert.equal(run.recompile(mjcfOf(i % 2 ? "stacked_boxes" : "free")), undefined);
    buffers.add(run.simulation.opened.buffer);
    if (i === 30) buffers.clear(); // the first ones may leave gaps
  }
  assert.equal(buffers.size, 1);
  run.free();
});
