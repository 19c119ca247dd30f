// The fonts that a page asks for arrive, and its text and formulas are set in them.

import { pages, testSite } from "./browser.mjs";

// For each family that a page declares from a file: what became of its faces.
async function faces() {
  await document.fonts.ready;
  return [...document.fonts].map(({ family, status }) => ({
    family: family.replaceAll('"', ""),
    status,
  }));
}

const firstFamily = (selector) =>
  getComputedStyle(document.querySelector(selector)).fontFamily.split(",")[0].replaceAll('"', "");

await testSite(async (visitor) => {
  for (const path of pages) {
    await visitor.visit(path, {}, async (page) => {
      const all = await page.evaluate(faces);
      const loaded = new Set(all.filter((f) => f.status === "loaded").map((f) => f.family));
      for (const selector of ["body", "h1", ".prose p", "pre code", ".katex .mathnormal"]) {
        if ((await page.locator(selector).count()) === 0) continue;
        const family = await page.evaluate(firstFamily, selector);
        visitor.expect(loaded.has(family), path, `${selector} is to be set in ${family}, not here`);
      }
    });
  }
});
