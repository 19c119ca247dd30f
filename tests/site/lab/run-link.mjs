// A lab in a link: there and back with the same bits, and what is no such link does no harm.
//
//   node --test tests/site/lab/run-link.mjs

import assert from "node:assert/strict";
import { test } from "node:test";
import { deflateRawSync } from "node:zlib";

import { gravitySlider, lab, mjcfOf, newEngine, openRun } from "./run-harness.mjs";

const engine = await newEngine();
const { decodeLink, encodeLink, headOf } = lab;

const camera = {
  azimuth: 90,
  elevation: -12.5,
  distance: 1.6,
  target: [0, 0.1, 0.45],
};

test("there and back", async () => {
  const state = Float64Array.of(0.1, -0, 5e-324, Number.MAX_VALUE, 1 / 3);
  const link = {
    id: "lab-1",
    camera,
    overlays: ["joints", "frames"],
    speed: 0.25,
    run: {
      settings: [null, 0.3, true, 2],
      run: { how: "step", state },
      ghost: { how: "reset", state: undefined },
    },
    mjcf: "<mujoco>\n  <!-- ü 模 -->\n</mujoco>\n",
  };
  const text = await encodeLink(link);
  assert.match(text, /^2\.lab-1\.37\.[\w-]+$/);
  assert.deepEqual(headOf(text), { id: "lab-1", mjcfBytes: 37, characters: text.length });
  const back = await decodeLink(text);
  assert.deepEqual(back, link);
  assert.ok(Object.is(back.run.run.state[1], -0));
  assert.deepEqual(await decodeLink(await encodeLink({ id: "a.1.2" })), { id: "a.1.2" });
});

test("a state that is too long is left out, a text that is too long has no link", async () => {
  const noise = (count) => Float64Array.from({ length: count }, (_, i) => Math.sin(i));
  const run = { settings: [1], run: { how: "step", state: noise(5000) } };
  const text = await encodeLink({ id: "a", run });
  assert.deepEqual(await decodeLink(text), { id: "a", run: { settings: [1] } });
  const mjcf = Array.from(noise(5000)).join(" ");
  assert.equal(await encodeLink({ id: "a", mjcf }), undefined);
  assert.equal(await encodeLink({ id: "a", mjcf: " ".repeat(3e5) }), undefined);
});

test("what is no link gives nothing", async () => {
  const packed = (text) => deflateRawSync(text).toString("base64url");
  const of = (json) => `2.x.0.${packed(JSON.stringify(json))}`;
  const brings = (bytes, mjcf) => `2.x.${bytes}.${packed(JSON.stringify({ mjcf }))}`;
  assert.deepEqual(await decodeLink(of({})), { id: "x" });
  assert.deepEqual(await decodeLink(brings(3, "<a>")), { id: "x", mjcf: "<a>" });
  const state = (values) => Buffer.from(Float64Array.from(values).buffer).toString("base64url");
  const whole = await encodeLink({ id: "lab-1", camera });
  const hostile = [
    ...["", "1", "2abc", "%", "2.x.0.", "2.x.0.%%%", "2.x.0.////", "2.x.0.abc", "2.x.0.A"],
    ...[whole.slice(0, -5), `${whole}x`, whole.replace("2.", "1."), whole.replace(".0.", ".x.")],
    ...["x".repeat(8000), `2.x.0.${"A".repeat(100_000)}`],
    `2.x.0.${packed("x".repeat(50e6)).slice(0, 7000)}`,
    brings(3e5, " ".repeat(3e5)),
    `2.x.0.${packed("[".repeat(200_000))}`,
    // More, less or something else than it says.
    ...[brings(0, "<a>"), brings(4, "<a>"), brings(2, "<a>"), brings(3)],
    ...[null, 1, "a", { overlays: "joints" }].map(of),
    ...[{ overlays: [1] }, { speed: "1" }, { mjcf: 5 }, { run: 1 }].map(of),
    of({ camera: { ...camera, target: [0, 1] } }),
    of({ camera: { ...camera, distance: null } }),
    of({ run: { settings: ["1"] } }),
    of({ run: { run: { how: "jump", state: state([1]) } } }),
    of({ run: { run: { how: "step" } } }),
    of({ run: { run: { how: "step", state: state([NaN]) } } }),
    of({ run: { run: { how: "step", state: state([Infinity]) } } }),
    of({ run: { run: { how: "step", state: "AAA" } } }),
  ];
  for (const text of hostile) {
    assert.equal(await decodeLink(text), undefined, text.slice(0, 60));
  }
  const known = await decodeLink(of({ id: "y", __proto__: { speed: 3 }, speed: 99, more: 1 }));
  assert.deepEqual(known, { id: "x", speed: 4 });
});

test("a run goes on elsewhere with the same bits", async () => {
  const describe = ({ run, ...kinds }) => ({
    controls: [
      gravitySlider(kinds),
      { type: "button", label: "Hop", run: run("data.qvel[2] = 1") },
    ],
    ghost: { label: "finer", run: run("model.opt.timestep /= 2") },
  });
  const run = await openRun(engine, mjcfOf("stacked_boxes"), describe);
  run.operate(0, -5);
  run.step(150);
  run.operate(1, null);
  run.step(77);
  const text = await encodeLink({ id: "lab-1", run: run.state });
  const other = await openRun(engine, mjcfOf("stacked_boxes"), describe);
  const link = await decodeLink(text);
  other.restore(link.run);
  assert.equal(other.time, run.time);
  assert.equal(other.settings[0], -5);
  for (const each of [run, other]) each.step(100);
  assert.deepEqual(other.simulation.state, run.simulation.state);
  assert.deepEqual(other.ghost.simulation.state, run.ghost.simulation.state);

  // of another lab: what does not fit is left out
  other.restore({
    settings: [99, 5, 7],
    run: { how: "step", state: Float64Array.of(1, 2) },
  });
  assert.equal(other.time, 0);
  assert.equal(other.settings[0], 0);
  assert.equal(other.step(10), 10);
  run.free();
  other.free();
});
