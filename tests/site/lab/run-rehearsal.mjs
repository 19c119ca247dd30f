// In each lab of a built site every reading of the build's rehearsal comes out again, to the last
// printed digit, in the engine of the page; and of a ghost, the traces of the plots to ten digits.
// MJCOURSE_SITE is the site's folder.
//
//   node --test tests/site/lab/run-rehearsal.mjs

import assert from "node:assert/strict";
import { globSync, readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";

import { lab, newEngine } from "./run-harness.mjs";

const labs = path.join(process.env.MJCOURSE_SITE, "labs");
const records = globSync("*.rehearsal.json", { cwd: labs }).sort();
const engine = await newEngine();

// The module of a lab, and its run.
async function open(name) {
  const [file] = globSync(`${name}-*.js`, { cwd: labs });
  const module = await import(pathToFileURL(path.join(labs, file)));
  const { texts, assets } = module.lab.model;
  const fetched = Object.entries(assets).map(([asset, address]) => [
    asset,
    readFileSync(path.join(labs, address)),
  ]);
  const run = new lab.Run(engine, module, {
    ...texts,
    ...Object.fromEntries(fetched),
  });
  return { run, scripts: module.scripts };
}

// What the rehearsal did for this run: a toggle is switched off after on, and what is on from the
// start is not switched on.
function act(run, control, value) {
  const { type, value: initial } = run.lab.controls[control];
  if (type === "toggle" && value === initial) {
    if (value) return;
    run.operate(control, true);
  }
  run.operate(control, value);
}

const inTenDigits = (number) => number.toPrecision(10);

// What the plots' traces are of the ghost, one plot after the other; undefined without a ghost.
function tracesOfGhost(run, scripts) {
  return (
    run.ghost &&
    run.lab.plots.flatMap(({ traces }) =>
      traces.map(({ value }) => inTenDigits(scripts[value](run.ghost.simulation.world))),
    )
  );
}

test("there are labs", () => assert.ok(records.length > 0, labs));

for (const record of records) {
  const name = path.basename(record, ".rehearsal.json");
  test(`lab ${name}`, async () => {
    const { runs, predicted } = JSON.parse(readFileSync(path.join(labs, record), "utf8"));
    const { run, scripts } = await open(name);
    for (const { control, value, readings } of runs) {
      run.reset();
      if (control !== null) act(run, control, value);
      let done = 0;
      for (const { steps, values, ghost } of readings) {
        done += run.step(steps - done);
        const printed = values.map((_, i) => run.printed(i));
        const when = `control ${control} at ${value} after ${steps} steps`;
        assert.deepEqual(printed, values, when);
        assert.deepEqual(tracesOfGhost(run, scripts), ghost?.map(inTenDigits), `ghost: ${when}`);
      }
      assert.equal(run.trouble, undefined);
    }
    if (run.lab.predict !== null) {
      run.predict();
      while (run.predicting) run.step(1000);
      assert.equal(lab.fixed(run.measured, run.lab.predict.digits), predicted);
    }
    run.free();
  });
}
