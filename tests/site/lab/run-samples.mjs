// What plots show: windows, thinning that keeps spikes, words, CSV.
//
//   node --test tests/site/lab/run-samples.mjs

import assert from "node:assert/strict";
import { test } from "node:test";

import { lab } from "./run-harness.mjs";

const plot = (window, ...labels) => ({
  ...{ ylabel: "y", window, ymin: null, ymax: null },
  traces: labels.map((label) => ({ label, value: 0 })),
});

test("the window moves on with time", () => {
  const samples = new lab.Samples(plot(5, "a"));
  for (let i = 0; i <= 1000; i++) samples.append(i / 100, [i]);
  const { times, traces } = samples.curves();
  // and the sample before, from which the curve comes
  assert.deepEqual([times[0], times.at(-1), times.length], [5, 10, 501]);
  assert.deepEqual([traces[0][0], traces[0].at(-1)], [500, 1000]);
  const past = samples.curves(7).times;
  assert.deepEqual([past[0], past.at(-1)], [2, 7]);
  assert.deepEqual(samples.curves(-1), { times: [], traces: [[]] });
});

test("a sample at the same time takes the place of the last", () => {
  const samples = new lab.Samples(plot(5, "a"));
  samples.append(0, [1]);
  samples.append(0, [2]);
  samples.append(1, [3]);
  assert.deepEqual(samples.curves(), { times: [0, 1], traces: [[2, 3]] });
  samples.truncate(0.5, 0);
  assert.deepEqual(samples.curves(), { times: [0], traces: [[2]] });
  samples.clear();
  assert.deepEqual(samples.curves(), { times: [], traces: [[]] });
});

test("of many samples the extremes remain", () => {
  const samples = new lab.Samples(plot(60, "wave", "spike"));
  const spikes = new Map([
    [12_345, 7],
    [33_333, -9],
  ]);
  for (let i = 0; i < 60_000; i++) {
    samples.append(i / 1000, [Math.sin(i / 500), spikes.get(i) ?? 0]);
  }
  const { times, traces } = samples.curves();
  assert.ok(times.length > 1000 && times.length <= 2002, `${times.length} points`);
  assert.deepEqual([times[0], times.at(-1)], [0, 59.999]);
  assert.ok(times.every((time, i) => i === 0 || time > times[i - 1]));
  assert.deepEqual([Math.max(...traces[1]), Math.min(...traces[1])], [7, -9]);
  for (const [row, height] of spikes) {
    const near = traces[1].findIndex((value) => value === height);
    assert.ok(Math.abs(times[near] - row / 1000) <= 0.06);
  }
  // a curve that moves on keeps its points
  samples.append(60, [0, 0]);
  const later = samples.curves();
  const known = new Set(times.map((time, i) => `${time} ${traces[0][i]}`));
  const kept = later.times.filter((time, i) => known.has(`${time} ${later.traces[0][i]}`));
  assert.ok(kept.length > 0.99 * times.length);
});

test("the older half goes when there are very many", () => {
  const samples = new lab.Samples(plot(1, "a"));
  for (let i = 0; i < 230_000; i++) samples.append(i, [i]);
  const rows = samples.csv().trimEnd().split("\r\n");
  assert.ok(rows.length > 50_000 && rows.length <= 100_001);
  assert.equal(rows.at(-1), "229999,229999");
});

test("in words", () => {
  const samples = new lab.Samples(plot(5, "a", "b"));
  [1, 4, -2, 3].forEach((value, i) => samples.append(i, [value, NaN]));
  assert.deepEqual(samples.summary(), [
    { label: "a", latest: 3, lowest: -2, highest: 4 },
    { label: "b", latest: undefined, lowest: undefined, highest: undefined },
  ]);
  assert.equal(samples.summary(1)[0].highest, 4);
  assert.equal(samples.summary(0)[0].highest, 1);
  assert.deepEqual(samples.curves().traces[1], [null, null, null, null]);
});

test("a ghost has its own times", () => {
  const samples = new lab.Samples(plot(5, "a"), "coarse");
  samples.appendGhost(0, [10]);
  [0, 0.1, 0.2, 0.3].forEach((time, i) => samples.append(time, [i]));
  samples.appendGhost(0.25, [11]);
  assert.deepEqual(samples.curves(), {
    times: [0, 0.1, 0.2, 0.25, 0.3],
    traces: [
      [0, 1, 2, undefined, 3],
      [10, undefined, undefined, 11, undefined],
    ],
  });
  assert.equal(
    samples.csv(),
    "time (s),a,a (coarse)\r\n0,0,10\r\n0.1,1,\r\n0.2,2,\r\n0.25,,11\r\n0.3,3,\r\n",
  );
  samples.truncate(0.15, 0);
  assert.deepEqual(samples.curves().times, [0, 0.1]);
});

test("labels are quoted where CSV asks for it", () => {
  const samples = new lab.Samples(plot(5, 'say "x", y', "two\nlines", "plain"));
  samples.append(0, [0.1, NaN, -1e-7]);
  assert.equal(samples.csv(), 'time (s),"say ""x"", y","two\nlines",plain\r\n0,0.1,,-1e-7\r\n');
});
