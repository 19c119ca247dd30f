// The fonts that a page asks for arrive, and its text and formulas are set in them; and they weigh no
// more than 100 KB together, with everything unfolded. A page's script asks ahead for what a browser
// would ask for later by itself, and for nothing else.

import { pages, testSite } from "./browser.mjs";

const mostBytes = 100_000;

function unfold() {
  for (const details of document.querySelectorAll("details")) details.open = true;
}

// For each family that a page declares from a file: what became of its faces. Those that are wanted are
// asked for in the next frame.
async function faces() {
  for (let frame = 0; frame < 2; ++frame) await new Promise(requestAnimationFrame);
  await document.fonts.ready;
  return [...document.fonts].map(({ family, status }) => ({
    family: family.replaceAll('"', ""),
    status,
  }));
}

// The sizes of the files that were loaded.
const sizes = () =>
  performance
    .getEntriesByType("resource")
    .filter(({ name }) => name.endsWith(".woff2"))
    .map(({ encodedBodySize }) => encodedBodySize);

const firstFamily = (selector) =>
  getComputedStyle(document.querySelector(selector)).fontFamily.split(",")[0].replaceAll('"', "");

// Without scripts nothing is asked for ahead.
async function neededBy(visitor, path) {
  const fonts = new Set();
  const before = (page) =>
    page.on("request", (request) => {
      if (request.resourceType() === "font") fonts.add(request.url());
    });
  await visitor.visit(path, { javaScript: false, before }, (page) =>
    page.waitForLoadState("networkidle"),
  );
  return fonts;
}

const askedFor = () =>
  [...document.querySelectorAll('link[rel="preload"][as="font"]')].map(({ href }) => href);

async function askOnlyForWhatIsNeeded(visitor, path) {
  const needed = await neededBy(visitor, path);
  await visitor.visit(path, {}, async (page) => {
    const asked = new Set(await page.evaluate(askedFor));
    const idle = [...asked].filter((font) => !needed.has(font));
    visitor.expect(idle.length === 0, path, `asks for ${idle}, which nothing is set in`);
    // A rare one may come later.
    const late = [...needed].filter((font) => !asked.has(font));
    visitor.expect(asked.size > 0 && late.length < 2, path, `does not ask for ${late}`);
  });
}

await testSite(async (visitor) => {
  // Of each fourth page, as the rule is the same for all.
  for (const path of pages.filter((_, index) => index % 4 === 0)) {
    await askOnlyForWhatIsNeeded(visitor, path);
  }
  for (const path of pages) {
    await visitor.visit(path, {}, async (page) => {
      await page.evaluate(unfold);
      const all = await page.evaluate(faces);
      const loaded = new Set(all.filter((f) => f.status === "loaded").map((f) => f.family));
      for (const selector of ["body", "h1", ".prose p", "pre code", ".katex .mathnormal"]) {
        if ((await page.locator(selector).count()) === 0) continue;
        const family = await page.evaluate(firstFamily, selector);
        visitor.expect(loaded.has(family), path, `${selector} is to be set in ${family}, not here`);
      }
      const files = await page.evaluate(sizes);
      const bytes = files.reduce((sum, size) => sum + size, 0);
      const good = files.length > 0 && files.every((size) => size > 0) && bytes <= mostBytes;
      visitor.expect(good, path, `${files.length} fonts weigh ${bytes} bytes`);
      console.log(`${path}: ${files.length} fonts, ${bytes} bytes`);
    });
  }
});
