// Takes the README's pictures of the site anew: site/screenshot*.png.
//
//   node tests/site/screenshots.mjs SITE

import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

import { folder, testSite } from "./browser.mjs";
import { Lab } from "./lab/lab.mjs";

const lesson = "1-state/1.2-generalized-coordinates.html";
const temporary = mkdtempSync(join(tmpdir(), "mjcourse-test-"));
const site = resolve(import.meta.dirname, "../../site");

// Of at most 256 colours, which is enough for a page and a third of the bytes.
async function take(page, name) {
  const whole = join(temporary, name);
  await page.screenshot({ path: whole });
  const palette = "split[a][b];[a]palettegen=reserve_transparent=0[p];[b][p]paletteuse=dither=none";
  const words = ["-loglevel", "error", "-y", "-i", whole, "-vf", palette, join(site, name)];
  execFileSync("ffmpeg", words);
}

const toTop = (locator) => locator.evaluate((e) => e.scrollIntoView({ behavior: "instant" }));

await testSite(async (visitor) => {
  await visitor.visit(lesson, { width: 1280 }, async (page) => {
    await page.setViewportSize({ width: 1280, height: 800 });
    const lab = await Lab.live(page, "lab-1");
    await lab.press("Turn the hinge (qvel[10] = 2 rad/s)");
    for (let i = 0; i < 40; ++i) await lab.root.getByRole("button", { name: "Ten steps" }).click();
    await lab.settle();
    await toTop(page.locator("h2", { hasText: "Mathematics" }));
    await take(page, "screenshot.png");
  });
  const phone = { width: 390, scheme: "dark", deviceScaleFactor: 2 };
  await visitor.visit(lesson, phone, async (page) => {
    await page.setViewportSize({ width: 390, height: 720 });
    const question = page.locator(".question").first();
    await question.getByRole("textbox").fill(await question.getAttribute("data-key"));
    await question.getByRole("button", { name: "Check" }).click();
    await toTop(question);
    await take(page, "screenshot-phone.png");
  });
});
rmSync(temporary, { recursive: true });
console.log(`taken of ${folder}`);
