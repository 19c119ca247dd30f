// How many steps a frame gets.
//
//   node --test tests/site/lab/run-clock.mjs

import assert from "node:assert/strict";
import { test } from "node:test";

import { lab, mjcfOf, newEngine, openRun } from "./run-harness.mjs";

// A clock whose steps take `cost` milliseconds, driven by frames.
function simulate({ speed = 1, timestep = 0.002, cost = 0.01 }) {
  let spent = 0;
  const clock = new lab.Clock(() => spent);
  clock.speed = speed;
  const simulated = { clock, cost, frame: (now) => clock.advance(now, step) };
  const step = () => {
    spent += simulated.cost;
    return timestep;
  };
  return simulated;
}

// Steps in a second of frames, and the last frame.
function second({ frame }, start = 0, rate = 60) {
  let steps = 0;
  let last;
  for (let i = 0; i <= rate; i++) {
    last = frame(start + (1000 * i) / rate);
    steps += last.steps;
  }
  return { steps, last };
}

test("simulated time keeps pace with real time", () => {
  for (const speed of [0.1, 1, 4]) {
    const { steps, last } = second(simulate({ speed }));
    assert.ok(Math.abs(steps - 500 * speed) <= 1, `${steps} steps at speed ${speed}`);
    assert.equal(last.limited, false);
  }
  assert.ok(Math.abs(second(simulate({}), 0, 144).steps - 500) <= 1);
});

test("a step that is longer than a frame is taken when it is due", () => {
  const { steps } = second(simulate({ timestep: 0.1 }));
  assert.ok(steps === 10 || steps === 11, `${steps} steps`);
});

test("a pause is not made up for", () => {
  const clock = simulate({});
  assert.equal(clock.frame(0).steps, 0);
  assert.ok(clock.frame(16).steps <= 9);
  assert.ok(Math.abs(clock.frame(60_000).steps - 50) <= 1, "a tenth of a second at most");
  clock.clock.pause();
  assert.equal(clock.frame(70_000).steps, 0);
});

test("a frame does no more than fits into it", () => {
  const slow = simulate({ cost: 4 });
  const { steps, last } = second(slow);
  assert.equal(last.limited, true);
  assert.equal(last.steps, 3);
  assert.equal(steps, 180);
  assert.equal(slow.clock.label, "0.4× — slower than asked");
  assert.ok(Math.abs(slow.clock.rate - 0.36) < 0.01);
  // what was missed is not made up for
  slow.cost = 0.01;
  assert.ok(slow.frame(1016).steps <= 9);
});

test("the measured rate", () => {
  const quick = simulate({ speed: 2 });
  assert.equal(quick.clock.rate, undefined);
  assert.equal(quick.clock.label, "2.0×");
  second(quick);
  assert.ok(Math.abs(quick.clock.rate - 2) < 0.05);
  assert.equal(quick.clock.label, "2.0×");
  quick.clock.speed = 1;
  second(quick, 1000);
  second(quick, 2000);
  assert.equal(quick.clock.label, "1.0×");
  quick.frame(9000);
  assert.equal(quick.clock.rate, undefined, "measured anew after a pause");
});

test("a step of no length does not hang the page", () => {
  const { steps, limited } = second(simulate({ timestep: 0, cost: 1 })).last;
  assert.ok(limited && steps === 10);
});

test("a run plays, and stops by itself", async () => {
  const engine = await newEngine();
  const run = await openRun(engine, mjcfOf("slide"), ({ run, value }) => ({
    controls: [{ type: "button", label: "Burst", run: run("data.qvel[0] = 1e300") }],
    predict: {
      ...{
        question: "",
        run: null,
        seconds: 0.25,
        value: value("data.time"),
        digits: 2,
      },
      ...{ unit: "s", tolerance: 0, explanation: "" },
    },
    speed: 0.5,
  }));
  const playback = new lab.Playback(run);
  assert.equal(playback.speed, 0.5);
  let now = 0;
  const frames = (count) => {
    for (let i = 0; i < count; i++) playback.advance((now += 1000 / 60));
  };
  frames(10);
  assert.equal(run.time, 0);
  playback.play();
  frames(61);
  assert.ok(Math.abs(run.time - 0.5) < 0.005);
  assert.equal(run.history.length, 61);
  playback.pause();
  const { time } = run;
  frames(10);
  assert.equal(run.time, time);

  run.predict();
  playback.play();
  frames(60);
  assert.ok(!playback.playing);
  assert.ok(Math.abs(run.measured - 0.25) < 1e-9 && run.time === run.measured);

  playback.play();
  run.operate(0, null);
  frames(2);
  assert.ok(run.trouble && !playback.playing);
  playback.play();
  assert.ok(!playback.playing);
  run.free();
});
