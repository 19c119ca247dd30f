// A slider of a lab reaches both of its ends, whatever its steps are. The generator takes steps that
// are a whole number but for a millionth (generator/lesson/blocks/read_control.cpp).
//
//   node --test tests/site/lab/slider.mjs

import assert from "node:assert/strict";
import path from "node:path";
import { after, test } from "node:test";

import { build } from "../../../site/node_modules/esbuild/lib/main.js";
import { launch } from "../chromium.mjs";

const { outputFiles } = await build({
  entryPoints: [path.resolve(import.meta.dirname, "../../../site/browser/lab/controls/slider.ts")],
  bundle: true,
  format: "iife",
  globalName: "built",
  target: "es2022",
  write: false,
});
const browser = await launch();
after(() => browser.close());
const page = await browser.newPage();
await page.addScriptTag({ content: outputFiles[0].text });

// What the keys say, one after the other.
async function pressed(range, keys) {
  const said = await page.evaluateHandle((range) => {
    const said = [];
    const slider = { label: "Slider", digits: 3, unit: "", value: null, ...range };
    const view = globalThis.built.sliderView(slider, (value) => said.push(value));
    document.body.replaceChildren(view.element);
    document.querySelector("input").value = String(range.min);
    document.querySelector("input").focus();
    return said;
  }, range);
  for (const key of keys) await page.keyboard.press(key);
  return said.jsonValue();
}

const ranges = [
  { min: 0, max: 1, step: 0.1 },
  { min: -1, max: 1, step: 0.01 },
  { min: 0, max: 1, step: 0.3333333 },
  { min: 0, max: 1, step: 0.33333334 },
  { min: 0, max: Math.PI, step: Math.PI / 200 },
  { min: -Math.PI, max: Math.PI, step: 0.31415927 },
  { min: 0, max: 3, step: 1 },
];

for (const range of ranges) {
  test(`from ${range.min} to ${range.max} in steps of ${range.step}`, async () => {
    assert.deepEqual(await pressed(range, ["End", "Home"]), [range.max, range.min]);
    const [first] = await pressed(range, ["ArrowRight"]);
    assert.ok(Math.abs(first - range.min - range.step) < 1e-6 * range.step);
  });
}
