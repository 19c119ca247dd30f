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

// Nothing is drawn in a trial: what the page would make to draw it is counted.
const drawn = (asset, bodies, visual = "") =>
  `<mujoco><visual>${visual}</visual><asset>${asset}</asset><worldbody>${bodies}</worldbody></mujoco>`;
const ofSize = (size) => `width="${size}" height="${size}"`;
const finest = '<quality numslices="100" numstacks="100"/>';
const ghostly = 'contype="0" conaffinity="0"';
const balls = (count) => `<geom size="1" ${ghostly}/>`.repeat(count);
const texture = (size) => `<texture builtin="flat" type="2d" name="t" ${ofSize(size)}/>`;
const field = (size) => `<hfield name="h" nrow="${size}" ncol="${size}" size="9 9 1 1"/>`;
const corners = /^its model has \d+ corners of shapes to draw, and a link’s may have \d+ here$/;
const hill = `<geom type="hfield" hfield="h" ${ghostly}/>`;

test("nor what takes the page too much to draw", async () => {
  const pixels = await tried({ mjcf: drawn(texture(2049), "") });
  assert.deepEqual(pixels, [
    "its model has 4198401 pixels of textures, and a link’s may have 4194304 here",
    0,
  ]);
  const [hills] = await tried({ mjcf: drawn(field(900), hill) });
  assert.match(hills, corners);
  const [many] = await tried({ mjcf: drawn("", balls(450), finest) });
  assert.match(many, corners);
  const floors = `<geom type="plane" size="0 0 1" ${ghostly}/>`.repeat(120);
  const [infinite] = await tried({ mjcf: drawn("", floors) });
  assert.match(infinite, corners);
  const [sites] = await tried({ mjcf: drawn("", '<site pos="1 0 0"/>'.repeat(5100)) });
  assert.match(sites, /^its model has \d+ shapes to draw, and a link’s may have \d+ here$/);
});

test("but what is like it, and takes no more, may come", async () => {
  for (const mjcf of [
    drawn(texture(2048), ""),
    drawn(field(800), hill),
    drawn("", balls(350), finest),
    drawn("", balls(1), '<quality numslices="14000" numstacks="14000" numquads="9000"/>'),
  ]) {
    const [fault] = await tried({ mjcf });
    assert.equal(fault, undefined);
  }
});

// The link's state brings the balls into one another, and with that hundreds of contacts to draw.
test("what shows once the state is there is counted as well", async () => {
  const at = (x) => `<body pos="${x} 0 0"><freejoint/><geom size=".5"/></body>`;
  const row = (distance) => {
    const bodies = Array.from({ length: 25 }, (_, i) => at(i * distance)).join("");
    const room = '<size nconmax="400" njmax="1600" nstack="4000000"/>';
    return drawn("", bodies, finest).replace("<visual>", `${room}<visual>`);
  };
  const close = await openRun(engine, row(0.01));
  close.step();
  const run = close.state;
  close.free();
  const [alone] = await tried({ mjcf: row(2) });
  assert.equal(alone, undefined);
  const [fault] = await tried({ mjcf: row(2), run });
  assert.match(fault, corners);
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
