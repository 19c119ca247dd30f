// A ghost: a second run beside the first, which keeps up with it and cannot stop it.
//
//   node --test tests/site/lab/run-ghost.mjs

import assert from "node:assert/strict";
import { test } from "node:test";

import { mjcfOf, newEngine, openPlain, openRun } from "./run-harness.mjs";

const engine = await newEngine();

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
  const ghost = openPlain(engine, mjcfOf("double_pendulum"));
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
