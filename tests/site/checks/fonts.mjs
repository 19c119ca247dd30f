// The fonts that a page asks for arrive, and its text and formulas are set in them; and they weigh no
// more than 100 KB together, with everything unfolded. A page's script asks ahead for what a browser
// would ask for later by itself, and for nothing else.

const mostBytes = 100_000;

function unfold() {
  const folded = [...document.querySelectorAll("details:not([open])")];
  for (const details of folded) details.open = true;
  globalThis.foldAgain = () => folded.forEach((details) => (details.open = false));
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

const preloaded = () =>
  [...document.querySelectorAll('link[rel="preload"][as="font"]')].map(({ href }) => href);

// Gives what the page asks for ahead, below the site's root.
async function light(page, { expect, root }) {
  const asked = await page.evaluate(preloaded);
  await page.evaluate(unfold);
  const all = await page.evaluate(faces);
  const loaded = new Set(all.filter((f) => f.status === "loaded").map((f) => f.family));
  for (const selector of ["body", "h1", ".prose p", "pre code", ".katex .mathnormal"]) {
    if ((await page.locator(selector).count()) === 0) continue;
    const family = await page.evaluate(firstFamily, selector);
    expect(loaded.has(family), `${selector} is to be set in ${family}, and is not`);
  }
  const files = await page.evaluate(sizes);
  const bytes = files.reduce((sum, size) => sum + size, 0);
  const good = files.length > 0 && files.every((size) => size > 0) && bytes <= mostBytes;
  expect(good, `${files.length} fonts weigh ${bytes} bytes`);
  await page.evaluate(() => globalThis.foldAgain());
  return asked.map((address) => address.replace(root, ""));
}

// Resolves once all is there that the page, as it is laid out now, is set in.
async function setInFull() {
  document.body.getBoundingClientRect();
  await document.fonts.ready;
}

// Without scripts nothing is asked for ahead. Gives what the browser asks for by itself.
async function plain(page, { requests, root }) {
  await page.evaluate(setInFull);
  const fonts = requests.filter((request) => request.resourceType() === "font");
  return [...new Set(fonts.map((request) => request.url().replace(root, "")))];
}

export const looks = { light, plain };

export function conclude({ light: askedFor, plain: needed }, { expect }) {
  // Of each fourth page, as the rule is the same for all.
  for (const [path, asked] of [...askedFor].sort().filter((_, index) => index % 4 === 0)) {
    const idle = asked.filter((font) => !needed.get(path).includes(font));
    expect(idle.length === 0, path, `asks for ${idle}, which nothing is set in`);
    // A rare one may come later.
    const late = needed.get(path).filter((font) => !asked.includes(font));
    expect(asked.length > 0 && late.length < 2, path, `does not ask for ${late}`);
  }
}
