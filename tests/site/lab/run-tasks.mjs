// What the reader is asked to do: predict, reach a goal, answer a task.
//
//   node --test tests/site/lab/run-tasks.mjs

import assert from "node:assert/strict";
import { test } from "node:test";

import { mjcfOf, newEngine, openPlain, openRun } from "./run-harness.mjs";

const engine = await newEngine();

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
  const expected = openPlain(engine, mjcfOf("free"));
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

test("a task's number is held to its own size, and a whole one to its last digit", async () => {
  const task = (script) => ({ question: "", value: script, tolerance: 0, unit: "" });
  const run = await openRun(engine, mjcfOf("free"), ({ value }) => ({
    goal: { text: "", done: value("true") },
    editable: { tasks: [task(value("1.6e-19")), task(value("1e12 + 1"))] },
  }));
  assert.equal(run.judgeTask(0, 1.6e-19), true);
  assert.equal(run.judgeTask(0, 5e-19), false);
  assert.equal(run.judgeTask(1, 1e12 + 1), true);
  assert.equal(run.judgeTask(1, 1e12 + 2), false);
  run.free();
});
