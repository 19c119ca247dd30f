// What a lab reads in the page is what it read in the build, digit for digit. The build's rehearsal
// wrote down every readout after every control (labs/*.rehearsal.json); here a browser presses the
// same controls of the same labs and takes the same steps, with the buttons that a reader has.

import { readFileSync } from "node:fs";
import { join } from "node:path";

import { folder, pages, testSite } from "../browser.mjs";

let readings = 0;

await testSite(async (visitor) => {
  for (const path of pages) {
    await visitor.visit(path, {}, async (page) => {
      for (const lab of await page.locator("sim-lab[data-module]").all()) {
        await lab.evaluate((element) => element.scrollIntoView());
        await lab.locator(".lab-live").waitFor();
        await compare(visitor, path, lab, rehearsalOf(await lab.getAttribute("data-module")));
      }
    });
  }
  visitor.expect(readings > 0, "the site", "no lab has a reading");
  console.log(`${readings} readings compared`);
});

function rehearsalOf(module) {
  const record = module.replace("../", "").replace(/-[^-]+\.js$/, ".rehearsal.json");
  return JSON.parse(readFileSync(join(folder, record), "utf8"));
}

async function compare(visitor, path, lab, { readouts, runs }) {
  for (const { control, value, readings: expected } of runs) {
    const where = `${path} ${await lab.getAttribute("id")} control ${control} at ${value}`;
    const found = await lab.evaluate(run, {
      control,
      value,
      steps: expected.map((r) => r.steps),
    });
    for (const [index, { steps, values }] of expected.entries()) {
      readings += values.length;
      values.forEach((text, i) => {
        const shown = found[index][i];
        const what = `${readouts[i]} is ${shown} after ${steps} steps, ${text} in the build`;
        visitor.expect(shown === text, where, what);
      });
    }
  }
  const wrong = await lab.locator(".lab-trouble:visible").allInnerTexts();
  visitor.expect(wrong.length === 0, path, `trouble: ${wrong}`);
}

// In the page: from the start, sets the control, and gives what is read after so many steps.
async function run(lab, { control, value, steps }) {
  const live = lab.querySelector(".lab-live");
  const press = (name) => lab.querySelector(`.lab-moves [aria-label="${name}"]`).click();
  const frame = () => new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
  const operate = () => {
    const input = live
      .querySelector(".controls")
      .children[control].querySelector("button, input, select");
    if (input.matches("button")) return input.click();
    if (input.type === "checkbox") {
      // A switch that is off is switched on first; what is on already stays.
      if (!value && !input.checked) input.click();
      return value === input.checked ? undefined : input.click();
    }
    input.value = String(value);
    input.dispatchEvent(new Event(input.matches("select") ? "change" : "input"));
  };

  press("Back to the start");
  if (control !== null) operate();
  const found = [];
  let taken = 0;
  for (const wanted of steps) {
    for (; taken + 10 <= wanted; taken += 10) press("Ten steps");
    for (; taken < wanted; ++taken) press("One step");
    await frame();
    await frame();
    const values = live.querySelectorAll(".readouts .value");
    found.push([...values].map((element) => element.textContent));
  }
  return found;
}
