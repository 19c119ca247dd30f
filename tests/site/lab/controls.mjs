// Each kind of control acts at once, playing or not; time goes on, stops, and goes back bit for bit.
//
//   node tests/site/lab/controls.mjs SITE     where SITE is tests/site/lab/course, built

import { readFile } from "node:fs/promises";

import { testSite } from "../browser.mjs";
import { fourLabs, Lab } from "./lab.mjs";

await testSite(async (visitor) => {
  await visitor.visit(fourLabs, {}, async (page) => {
    const lab = await Lab.live(page, "lab-1");
    const shows = async (label, value, after) => {
      const shown = await lab.reading(label);
      visitor.expect(
        shown === value,
        fourLabs,
        `after ${after}, ${label} is ${shown}, not ${value}`,
      );
    };
    await tryControls(lab, shows);
    await tryTime(visitor, lab, shows);
    await tryPast(visitor, lab);
    await tryShown(visitor, lab);
    await tryCurves(visitor, lab);
  });
});

async function tryControls(lab, shows) {
  await shows("time", "0.000", "going live");
  const motor = lab.root.getByRole("slider", { name: "Motor" });
  await motor.fill("0.5");
  await lab.settle();
  await shows("motor", "0.50", "moving the slider");
  await lab.root.getByRole("switch", { name: "Gravity" }).click();
  await lab.settle();
  await shows("gravity", "0.00", "switching gravity off");
  await lab.root.getByRole("combobox", { name: "Pole", exact: true }).selectOption("stands");
  await lab.settle();
  await shows("angle", "3.1416", "choosing an option");
  await lab.press("Tilted");
  await shows("angle", "0.8000", "the keyframe");
  await lab.press("Back to the start");
  await shows("angle", "0.0000", "a reset");
  await shows("motor", "0.00", "a reset");
  await shows("gravity", "-9.81", "a reset");
}

async function tryTime(visitor, lab, shows) {
  await lab.press("One step");
  await shows("time", "0.005", "a step");
  await lab.press("Ten steps");
  await shows("time", "0.055", "ten steps more");
  await lab.press("Kick the cart");
  await lab.button("Play").first().click();
  await lab.runs();
  await lab.press("Pause");
  visitor.expect(await lab.rests(), fourLabs, "time goes on after Pause");
  await lab.root.getByRole("combobox", { name: "Speed" }).selectOption("0.25×");
  await lab.press("Back to the start");
  await shows("time", "0.000", "a reset");
}

async function tryPast(visitor, lab) {
  await lab.press("Kick the cart");
  const seen = [await lab.readings()];
  for (let i = 0; i < 4; ++i) {
    await lab.press("Ten steps");
    seen.push(await lab.readings());
  }
  const scrubber = lab.root.getByRole("slider", { name: "Rewind" });
  const back = async (keys) => {
    for (let i = 0; i < keys; ++i) await scrubber.press("ArrowLeft");
    await lab.settle();
  };
  await back(2);
  const then = await lab.readings();
  visitor.expect(then === seen[2], fourLabs, `two back: ${then}, not ${seen[2]}`);
  await lab.press("Ten steps");
  const again = await lab.readings();
  visitor.expect(again === seen[3], fourLabs, `and on: ${again}, not ${seen[3]}`);
}

async function tryShown(visitor, lab) {
  const before = await lab.picture();
  await lab.root.getByRole("checkbox", { name: "com" }).check();
  visitor.expect((await lab.picture()) !== before, fourLabs, "an overlay changes nothing");
  await lab.root.getByRole("checkbox", { name: "com" }).uncheck();
  visitor.expect((await lab.picture()) === before, fourLabs, "an overlay stays");
  // MuJoCo draws one kind of label at a time, and tendons by itself.
  await lab.root.getByRole("checkbox", { name: "labels", exact: true }).check();
  await lab.root.getByRole("checkbox", { name: "joint labels" }).check();
  await lab.settle();
  const shown = await lab.shown();
  visitor.expect(shown === "joints tendons joint labels", fourLabs, `${shown} are shown`);
  await lab.root.getByRole("checkbox", { name: "joint labels" }).uncheck();
  await lab.press("camera");
  await lab.press("Top");
  visitor.expect((await lab.picture()) !== before, fourLabs, "Top looks as before");
  await lab.press("camera");
  await lab.press("Lesson’s view");
  visitor.expect((await lab.picture()) === before, fourLabs, "the lesson’s view differs");
}

async function tryCurves(visitor, lab) {
  const rows = await lab.root.locator(".lab-plot tbody tr").allTextContents();
  visitor.expect(rows.length === 2 && /^x-?\d/.test(rows[0]), fourLabs, `in words: ${rows}`);
  await lab.press("copy");
  const download = lab.page.waitForEvent("download");
  await lab.press("Download the curves of “cart and pole” (CSV)");
  const csv = await readFile(await (await download).path(), "utf8");
  const [head, first] = csv.split("\r\n");
  visitor.expect(head === "time (s),x,angle", fourLabs, `the CSV begins ${head}`);
  visitor.expect(first === "0,0,0", fourLabs, `the CSV goes on ${first}`);
}
