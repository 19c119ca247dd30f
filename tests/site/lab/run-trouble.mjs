// What a script or the physics does wrong: the run stops and says where.
//
//   node --test tests/site/lab/run-trouble.mjs

import assert from "node:assert/strict";
import { test } from "node:test";

import { lab, mjcfOf, newEngine, openRun } from "./run-harness.mjs";

const engine = await newEngine();

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

// MuJoCo's data of `mebibytes`, which are never touched.
const large = (mebibytes, inside = "") =>
  `<mujoco><size nstack="${Math.round(mebibytes * 131072)}"/><worldbody>${inside}</worldbody></mujoco>`;

test("the largest model is edited again and again, also with a ghost", async () => {
  for (const [ghosts, mebibytes] of [
    [0, 630],
    [1, 310],
  ]) {
    const young = await newEngine();
    const run = await openRun(young, large(mebibytes), ({ run }) => ({
      ghost: ghosts === 0 ? null : { label: "slow", run: run("model.opt.timestep *= 2") },
    }));
    run.visualization.camera = { ...run.visualization.camera, azimuth: 33 };
    for (let edit = 1; edit <= 6; edit++) {
      // somewhat larger each time, so that it does not fit where the former was
      assert.equal(run.recompile(large(mebibytes + edit)), undefined);
      assert.equal(run.visualization.update(), true);
      assert.equal(run.step(3), 3);
    }
    assert.equal(run.visualization.camera.azimuth, 33);
    run.free();
  }
});

test("an edited model for which the page has no room", async () => {
  const young = await newEngine();
  const run = await openRun(young, large(100, "<geom size='1'/>"));
  run.visualization.camera = { ...run.visualization.camera, azimuth: 33 };
  const refused = (mebibytes) => {
    run.step(7);
    const error = run.recompile(large(mebibytes));
    assert.deepEqual(
      [error.name, error.message, error.file, error.line, error.cure],
      [
        "LoadError",
        "the page has no memory left for this model",
        "model.xml",
        0,
        "smaller meshes, textures and height fields, or a smaller `njmax`, `nconmax` or `nstack` in " +
          "its `<size>`",
      ],
    );
    // The former starts anew.
    assert.equal(run.time, 0);
    assert.equal(run.visualization.camera.azimuth, 33);
    assert.equal(run.visualization.update(), true);
    assert.equal(run.scene.geoms.length, 1);
  };
  refused(4110); // beyond what an address of the engine can say
  refused(2100); // for its simulation
  refused(1200); // for its scene
  assert.equal(run.step(2), 2);
  assert.equal(run.recompile(large(150)), undefined);
  // A reader's own word is no lack of memory.
  const { message } = run.recompile(`<mujoco><size memory="1M"/></mujoco>`);
  assert.match(message, /unrecognized attribute: 'memory'/);
  run.free();
});

test("a model that the page has no room for, and the next that has", async () => {
  const asks = (nstack) => `<mujoco><size nstack="${nstack}"/></mujoco>`;
  // Twice as much: for the simulation, and for its scene.
  for (const nstack of [400e6, 200e6]) {
    let run;
    const open = async () => {
      run = await openRun(engine, asks(nstack));
      return run.visualization;
    };
    await assert.rejects(open(), (error) => {
      assert.equal(
        lab.whyNoStart(error),
        "The page has no memory left for this lab’s model, so it stays a picture. Reload the " +
          "page and play this lab first.",
      );
      return true;
    });
    run?.free();
  }
  const run = await openRun(engine, asks(20e6));
  assert.ok(run.visualization);
  run.free();
  const mistake = new TypeError("x is not a function");
  assert.equal(lab.whyNoStart(mistake), "The lab could not be started: x is not a function");
});
