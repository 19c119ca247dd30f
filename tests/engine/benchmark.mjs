// Steps per second, engine and native library in turn: node tests/engine/benchmark.mjs

import path from "node:path";

import { load, models, nativeSpeed, newEngine } from "./harness.mjs";

const model = path.join(models, "box_and_sphere.xml");
const steps = 50_000;
const simulation = load(await newEngine(), model);

function engineSpeed() {
  simulation.reset();
  const start = performance.now();
  simulation.step(steps);
  return (1000 * steps) / (performance.now() - start);
}

engineSpeed(); // once for the compiler
const runs = Array.from({ length: 5 }, () => ({
  native: nativeSpeed(model, steps),
  engine: engineSpeed(),
}));
const best = (of) => Math.max(...runs.map((run) => run[of]));
console.log(`native ${Math.round(best("native"))} steps/s, engine ${Math.round(best("engine"))}`);
console.log(`ratio ${(best("engine") / best("native")).toFixed(2)}`);
