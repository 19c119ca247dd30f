// What a link brings is tried before the page does it: what is too large, what no step may do, and what does
// not compile is said in a clause, and all else may come.
//
//   node --test tests/site/lab/run-trial.mjs

import assert from "node:assert/strict";
import { test } from "node:test";

import { lab, mjcfOf, newEngine, openRun } from "./run-harness.mjs";

const engine = await newEngine();
const { tryLink } = lab;

const editable = () => ({ editable: { tasks: [] } });
const withGeoms = (count) => {
  const geoms = '<geom size="1"/>'.repeat(count);
  return `<mujoco><worldbody>${geoms}</worldbody></mujoco>`;
};
const withOption = (text) =>
  `<mujoco><option ${text}/><worldbody><geom size="1"/></worldbody></mujoco>`;

async function tried(link, describe = editable, model = mjcfOf("slide")) {
  const run = await openRun(engine, model, describe);
  const fault = tryLink(run, { id: "lab-1", ...link });
  const { ngeom } = run.simulation.world.model;
  run.free();
  return [fault, ngeom];
}

test("what is like a lesson's may come", async () => {
  assert.deepEqual(await tried({}), [undefined, 1]);
  assert.deepEqual(await tried({ mjcf: withGeoms(1001) }), [undefined, 1001]);
  assert.deepEqual(await tried({ mjcf: withOption('iterations="1000"') }), [undefined, 1]);
  assert.deepEqual(await tried({ mjcf: mjcfOf("stacked_boxes"), overlays: ["joints", "none"] }), [
    undefined,
    4,
  ]);
});

test("what is too large may not", async () => {
  const [many] = await tried({ mjcf: withGeoms(1002) });
  assert.equal(many, "its model has 1002 geoms, and a link’s may have 1001 here");
  const texture = '<texture builtin="flat" type="2d" name="t" width="5000" height="5000"/>';
  const [large] = await tried({ mjcf: `<mujoco><asset>${texture}</asset></mujoco>` });
  assert.match(large, /^its model has \d+ bytes of memory, and a link’s may have \d+ here$/);
});

test("nor what no step may do", async () => {
  for (const name of ["iterations", "noslip_iterations", "mpr_iterations"]) {
    const [fault] = await tried({ mjcf: withOption(`${name}="1001"`) });
    assert.equal(fault, `its model sets ${name} to 1001, and a link’s may have 1000`);
  }
});

test("nor what does not compile", async () => {
  const [fault] = await tried({ mjcf: "<mujoco><worldbody><geom/></worldbody></mujoco>" });
  assert.match(fault, /^its model does not compile: \S/);
});

test("a model comes only where the lesson’s can be edited", async () => {
  assert.deepEqual(await tried({ mjcf: withGeoms(2000) }, () => ({})), [undefined, 1]);
});

test("the state is put in place, and steps are taken from there", async () => {
  const run = await openRun(engine, mjcfOf("slide"));
  run.step(50);
  const other = await openRun(engine, mjcfOf("slide"));
  assert.equal(tryLink(other, { id: "lab-1", run: run.state }), undefined);
  run.step(20);
  assert.equal(other.time, run.time);
  run.free();
  other.free();
});
