// With the system's colours instead of ours formulas have as much ink as before: a browser puts plates
// behind texts then, which may cover others.
//
//   node tests/site/forced-colours.mjs SITE

import { pagesWith, testSite } from "./browser.mjs";

// Each is on the first page that has such a thing: a class in its HTML, and what is looked at.
const drawn = [
  ["frac-line", ".katex:has(.frac-line)"],
  ["accent-body", ".katex:has(.accent-body)"],
];

// How many pixels of a picture of dark on light are nearer to its darkest than to its lightest.
async function ink(png) {
  const bitmap = await createImageBitmap(new Blob([Uint8Array.from(png)]));
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
  context.drawImage(bitmap, 0, 0);
  const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
  const green = data.filter((_, i) => i % 4 === 1);
  const lightest = green.reduce((one, other) => Math.max(one, other));
  const darkest = green.reduce((one, other) => Math.min(one, other));
  return green.filter((value) => value < (darkest + lightest) / 2).length;
}

await testSite(async (visitor) => {
  for (const [text, selector] of drawn) {
    const [path] = pagesWith(text);
    if (!visitor.expect(path, "the site", `has no ${selector}`)) continue;
    const found = {};
    for (const forcedColors of ["none", "active"]) {
      await visitor.visit(
        path,
        { forcedColors, savesData: true, deviceScaleFactor: 3 },
        async (page) => {
          await page.evaluate(() => document.fonts.ready);
          const element = page.locator(selector).filter({ visible: true }).first();
          await element.scrollIntoViewIfNeeded();
          await page.waitForLoadState("networkidle"); // fonts that it asked for
          found[forcedColors] = await page.evaluate(ink, [...(await element.screenshot())]);
        },
      );
    }
    const share = found.active / found.none;
    visitor.expect(
      Math.abs(share - 1) < 0.1,
      `${path} ${selector}`,
      `has ${found.active} pixels of ink, not about ${found.none}`,
    );
  }
});
