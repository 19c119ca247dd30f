// The hand that pushes and pulls a body.
//
//   node --test tests/site/lab/run-hand.mjs

import assert from "node:assert/strict";
import { test } from "node:test";

import { mjcfOf, newEngine, openRun } from "./run-harness.mjs";

const engine = await newEngine();

test("a hand pulls, and its force goes with it", async () => {
  const run = await openRun(engine, mjcfOf("free"), ({ run }) => ({
    ghost: { label: "same", run: run("model.opt.timestep *= 1") },
  }));
  const { visualization } = run;
  const body = visualization.select(1, 0.5, 0.5);
  const push = () => [...run.simulation.world.data.xfrc_applied];
  assert.equal(body, 0, "nothing is seen where the lab does not look");
  visualization.camera = {
    azimuth: 90,
    elevation: 0,
    distance: 1,
    target: bodyPlace(run, 1),
  };
  visualization.update();
  assert.equal(visualization.select(1, 0.5, 0.5), 1);
  run.hold("pull");
  visualization.drag("moveVertical", 0.2, 0);
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
