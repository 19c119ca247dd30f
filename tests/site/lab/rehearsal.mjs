// The page gives the numbers of the build: every control of every lab, used as the rehearsal used it,
// and every readout at every moment that the rehearsal wrote down, digit for digit.
//
//   node tests/site/lab/rehearsal.mjs SITE [SHARES]
//
// With SHARES, a control is used once, at one of its values, and read once, and of the models' pages, whose
// labs are all alike, a share is opened: so many commits try other values, moments and models (sample.mjs).
// All digits come out of the same engine in run-rehearsal.mjs.

import { readFileSync } from "node:fs";
import { join } from "node:path";

import { sampleOf } from "../../sample.mjs";
import { folder, pages, testSite } from "../browser.mjs";
import { Lab } from "./lab.mjs";

// Once a lab has shown its picture, only its numbers are looked at: drawn without a graphics card, the
// pictures of all these moments would take half of the time.
function drawInstances(wanted) {
  const { prototype } = WebGL2RenderingContext;
  prototype.reallyDraw ??= prototype.drawElementsInstanced;
  prototype.drawElementsInstanced = wanted ? prototype.reallyDraw : () => {};
}

const sample = sampleOf(Number(process.argv[3] ?? 1));

// Of the runs of a lab with all their readings, those that are tried.
function tried(runs) {
  if (sample.all) return runs;
  const one = (all) => all[sample.share % all.length];
  const ofControls = Map.groupBy(runs, ({ control }) => control);
  return [...ofControls.values()].map(one).map((run) => {
    return { ...run, readings: run.readings.length > 0 ? [one(run.readings)] : [] };
  });
}

await testSite(async (visitor) => {
  let readings = 0;
  for (const path of pages) {
    const number = (/^models\/(.+)\.html$/.exec(path) ?? /\/(\w+\.\d+)-/.exec(path))?.[1];
    if (number === undefined) continue; // neither a model nor a lesson, and so without labs
    if (path.startsWith("models/") && !sample.has(path)) continue;
    await visitor.visit(path, {}, async (page) => {
      const labs = page.locator("sim-lab[data-code]");
      for (let index = 1; index <= (await labs.count()); ++index) {
        // Two that a page has no room for together (trouble.mjs).
        if (await page.locator(`#lab-${index}[data-large]`).count()) continue;
        await page.evaluate(drawInstances, true);
        const lab = await Lab.live(page, `lab-${index}`);
        await page.evaluate(drawInstances, false);
        const record = join(folder, "labs", `${number}-${index}.rehearsal.json`);
        const { runs } = JSON.parse(readFileSync(record, "utf8"));
        // There are many models; half a second of each run is enough of them.
        const kept = path.startsWith("models/") ? 2 : undefined;
        const some = runs.map((run) => ({ ...run, readings: run.readings.slice(0, kept) }));
        for (const run of tried(some)) {
          readings += await rerun(visitor, lab, run, `${path} lab-${index}`);
        }
      }
    });
  }
  visitor.expect(readings > 0, folder, "no rehearsal has readings");
});

// Gives how many readings there were to compare.
async function rerun(visitor, lab, { control, value = null, readings }, where) {
  await lab.press("Back to the start");
  if (control !== null) await operate(lab, control, value);
  let done = 0;
  for (const { steps, values } of readings) {
    await step(lab, steps - done);
    done = steps;
    const shown = await lab.readings();
    const what = `control ${control} (${value}), ${steps} steps: ${shown}, in the build ${values}`;
    visitor.expect(shown === values.join(" "), where, what);
  }
  return readings.length;
}

async function operate(lab, control, value) {
  const item = lab.root.locator(".lab-live .controls > li").nth(control);
  const [kind] = await item
    .locator("button, input, select")
    .evaluateAll((elements) => elements.map((element) => element.type));
  const field = item.locator("button, input, select");
  if (kind === "button") await field.click();
  else if (kind === "range") await field.fill(String(value));
  else if (kind === "select-one")
    await field.selectOption({ index: value + 1 }); // after "choose…"
  else await field.setChecked(value);
  await lab.settle();
}

// By the lab's own buttons, pressed faster than a hand could.
async function step(lab, count) {
  for (const [name, times] of [
    ["Ten steps", Math.floor(count / 10)],
    ["One step", count % 10],
  ]) {
    await lab.button(name).evaluate((button, presses) => {
      for (let i = 0; i < presses; ++i) button.click();
    }, times);
  }
  await lab.settle();
}
