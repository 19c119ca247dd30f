// Going back: what was, is again, bit for bit, and so is what follows.
//
//   node --test tests/site/lab/run-history.mjs

import assert from "node:assert/strict";
import { test } from "node:test";

import { gravitySlider, lab, mjcfOf, newEngine, openRun, slider } from "./run-harness.mjs";

const engine = await newEngine();

const plot = (value) => ({
  ...{ ylabel: "m", window: 5, ymin: null, ymax: null },
  traces: [{ label: "height", value: value("data.qpos[2]") }],
});

// Everything that scripts can read of mjData, but for how long MuJoCo took, its work space, and
// constraints past the last one.
function everything({ simulation }) {
  const { data } = simulation.world;
  const ownAffair = /^(timer|warning|solver|nstack|pstack|maxuse|efc_)/;
  const fields = Object.entries(data).filter(([name]) => !ownAffair.test(name));
  const values = fields.map(([name, value]) => [
    name,
    typeof value === "number" ? value : Array.from(value),
  ]);
  return {
    ...Object.fromEntries(values),
    forces: [...data.efc_force.slice(0, data.nefc)],
  };
}

// What drives the frames of a run: a hundred, with `act` in between.
function play(run, frames, act = () => undefined) {
  const seen = [];
  for (let frame = 0; frame < frames; frame++) {
    act(frame);
    run.step(8);
    run.keep();
    seen.push(everything(run));
  }
  return seen;
}

for (const name of ["stacked_boxes", "pick_place"]) {
  test(`each place is found again, and goes on as before: ${name}`, async () => {
    const run = await openRun(engine, mjcfOf(name), ({ value }) => ({
      plots: [plot(value)],
    }));
    const seen = play(run, 40);
    assert.ok(run.simulation.world.data.ncon > 0);
    assert.equal(run.history.length, 41);
    for (const index of [40, 7, 1, 23]) {
      run.seek(index);
      assert.deepEqual(everything(run), seen[index - 1]);
      assert.equal(run.history.length, 41, "nothing is forgotten by looking");
    }
    // from 23 on: twice, since a place may be sought where the run went on from another
    for (let i = 0; i < 2; i++) {
      run.seek(23);
      assert.deepEqual(play(run, 17), seen.slice(23));
      assert.equal(run.history.length, 41);
    }
    run.seek(0);
    assert.equal(run.time, 0);
    assert.deepEqual(play(run, 40), seen);
    run.free();
  });
}

test("what is scrubbed over is forgotten when the run goes on", async () => {
  const run = await openRun(engine, mjcfOf("stacked_boxes"), ({ value }) => ({
    plots: [plot(value)],
    ghost: null,
  }));
  play(run, 20);
  run.seek(5);
  const { time } = run;
  assert.equal(run.samples[0].curves().times.length, 161);
  run.step(1);
  assert.equal(run.history.length, 6);
  assert.equal(run.samples[0].curves().times.length, 42);
  assert.ok(run.time > time && run.samples[0].curves().times.at(-1) === run.time);
  run.free();
});

test("the past has its own gravity and its own controls", async () => {
  const run = await openRun(engine, mjcfOf("stacked_boxes"), ({ run, ...kinds }) => ({
    controls: [
      gravitySlider(kinds, -9.81),
      {
        ...{ type: "toggle", label: "Hop", value: false },
        ...{ on: run("data.qvel[2] = 1"), off: run("data.qvel[2] = 0") },
      },
    ],
    ghost: { label: "finer", run: run("model.opt.timestep /= 2") },
  }));
  const act = (frame) => {
    if (frame === 10) run.operate(0, -1);
    if (frame === 15) run.operate(1, true);
    if (frame === 20) run.operate(0, -15);
  };
  const seen = play(run, 30, act);
  const ghostly = run.ghost.simulation.state;
  run.seek(7);
  assert.deepEqual(run.settings, [-9.81, false]);
  const again = play(run, 23, (frame) => act(frame + 7));
  assert.deepEqual(again, seen.slice(7));
  assert.deepEqual(run.ghost.simulation.state, ghostly);
  run.seek(run.history.nearest(seen[17].time));
  assert.deepEqual(run.settings, [-1, true]);
  assert.equal(run.ghost.simulation.world.model.opt.gravity[2], -1);
  run.free();
});

test("a slider that is dragged while time stands leaves one place", async () => {
  const run = await openRun(engine, mjcfOf("slide"), (kinds) => ({
    controls: [
      slider(kinds, {
        ...{ label: "Place", bind: "data.qpos[0]", min: -1, max: 1 },
        ...{ value: 0.5, digits: 1, unit: "m" },
      }),
    ],
  }));
  for (let i = 0; i < 20; i++) run.operate(0, i / 20);
  assert.equal(run.history.length, 2);
  assert.equal(run.history.at(1).settings[0], 0.95);
  run.seek(0);
  assert.equal(run.settings[0], 0.5);
  run.free();
});

test("trouble is left behind by going back", async () => {
  const run = await openRun(engine, mjcfOf("slide"), ({ run }) => ({
    controls: [{ type: "button", label: "Burst", run: run("data.qvel[0] = 1e300") }],
  }));
  play(run, 10);
  run.operate(0, null);
  run.step(100);
  assert.ok(run.trouble);
  run.keep();
  run.seek(5);
  assert.equal(run.trouble, undefined);
  assert.equal(run.step(10), 10);
  run.free();
});

test("memory is bounded, and the first and the last place stay", () => {
  for (const most of [100, 99]) {
    const history = new lab.History(10 * most);
    for (let time = 0; time < 1000; time++) {
      history.append({ time, bytes: 10 });
      assert.ok(history.length <= most);
      assert.equal(history.at(0).time, 0);
      assert.equal(history.at(history.index)?.time, time);
    }
    assert.ok(history.length >= most / 2);
    const times = Array.from({ length: history.length }, (_, i) => history.at(i).time);
    assert.deepEqual(
      times,
      [...new Set(times)].sort((a, b) => a - b),
    );
  }
});

test("the nearest place", () => {
  const history = new lab.History();
  assert.equal(history.nearest(1), -1);
  for (const time of [0, 1, 1, 5]) history.append({ time, bytes: 1 });
  const nearest = [-3, 0.4, 0.6, 1, 2.9, 3.1, 99].map((time) => history.nearest(time));
  assert.deepEqual(nearest, [0, 0, 1, 2, 2, 3, 3]);
  history.seek(1);
  assert.ok(history.isPast);
  history.append({ time: 2, bytes: 1 });
  assert.equal(history.length, 3);
  assert.throws(() => history.seek(3), RangeError);
});
