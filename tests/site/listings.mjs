// Code as a reader uses it: buttons that copy, also where no script may; links to single lines; long
// outputs that unfold.
//
//   node tests/site/listings.mjs SITE
//
// The site is that of tests/site/listing-course.

import { pages, testSite } from "./browser.mjs";

const [path] = pages.filter((page) => page.endsWith("1.1-listings.html"));
const program = "#example-count .code code";
const text = (page, selector) =>
  page.$$eval(selector, (all) => all.map((one) => one.textContent).join(""));

async function copies(page, expect) {
  const listings = [
    ["Copy examples/count.cpp", program],
    ["Copy what was printed", "#example-count samp"],
    ["Copy this code", ".example:not([id]) .code code"],
  ];
  for (const [name, selector] of listings) {
    const button = page.getByRole("button", { name, exact: true }).first();
    await button.hover();
    const { height, width } = await button.boundingBox();
    expect(height >= 24 && width >= 24, `“${name}” is ${width} by ${height} px`);
    await button.click();
    const copied = await page.evaluate(() => navigator.clipboard.readText());
    const wanted = selector.startsWith(".")
      ? await page.locator(selector).first().textContent()
      : await text(page, selector);
    expect(copied === wanted && copied.length > 8, `“${name}” copies ${JSON.stringify(copied)}`);
    expect((await page.getByText("Copied").count()) > 0, `“${name}” does not tell`);
  }
  // One for each program, and for each output below one.
  const [buttons, listed] = await Promise.all([
    page.locator(".copy").count(),
    page.locator(".example > .code, .output:has(pre)").count(),
  ]);
  expect(buttons === listed, `${buttons} buttons for ${listed} listings`);
}

async function selects(page, expect) {
  await page.evaluate(() => {
    Object.defineProperty(navigator, "clipboard", { value: undefined });
  });
  await page.getByRole("button", { name: "Copy what was printed" }).first().click();
  const selected = await page.evaluate(() => getSelection().toString());
  expect(/^line 1:[^]*line 60: 0.017\s*$/.test(selected), `selects ${JSON.stringify(selected)}`);
  expect(!selected.includes("more lines"), "selects what is no output");
  expect((await page.getByText("Selected").count()) === 1, "does not say that it selected");
}

// Which line is lit, and where the band lies beside the line of text.
function lit(line) {
  const link = document.querySelector(`#count-L${line}`);
  const band = getComputedStyle(link, "::after");
  const page = document.querySelector(":target");
  const { top } = link.getBoundingClientRect();
  return {
    target: page?.id,
    lit: band.backgroundColor !== "rgba(0, 0, 0, 0)" && band.content !== "none",
    inView: top > 0 && top < innerHeight,
    color: band.backgroundColor,
  };
}

async function lines(page, expect) {
  const first = await page.evaluate(lit, 7);
  expect(first.target === "count-L7" && first.lit && first.inView, JSON.stringify(first));
  const code = await text(page, program);
  const numbered = await page.locator("#example-count .lines a").count();
  expect(numbered === code.trimEnd().split("\n").length, `${numbered} numbers`);
  // A number stands beside its line: that which the text of the line has.
  const apart = await page.evaluate(() => {
    const walker = document.createTreeWalker(
      document.querySelector("#example-count .code code"),
      NodeFilter.SHOW_TEXT,
    );
    const range = document.createRange();
    while (walker.nextNode()) {
      const at = walker.currentNode.data.indexOf("atoi");
      if (at < 0) continue;
      range.setStart(walker.currentNode, at);
      range.setEnd(walker.currentNode, at + 4);
    }
    const box = range.getBoundingClientRect();
    const number = document.querySelector("#count-L6").getBoundingClientRect();
    return Math.abs((box.top + box.bottom - number.top - number.bottom) / 2);
  });
  expect(apart < 4, `the number of line 6 stands ${apart} px beside it`);
  // Selecting the program takes no number along.
  await page.evaluate((selector) => {
    getSelection().selectAllChildren(document.querySelector(selector));
  }, program);
  const selected = await page.evaluate(() => getSelection().toString());
  expect(selected.trim() === code.trim(), `selecting takes ${JSON.stringify(selected)}`);
  // With the keyboard: one link for the program, and the arrows for the others.
  await page.getByRole("link", { name: "Line 1", exact: true }).first().focus();
  for (const key of ["ArrowDown", "ArrowDown", "Enter"]) await page.keyboard.press(key);
  const third = await page.evaluate(lit, 3);
  expect(third.target === "count-L3" && third.lit, JSON.stringify(third));
  const reached = await page.locator("#example-count .lines a:not([tabindex='-1'])").count();
  expect(reached === 1, `${reached} links to lines are in the way of the Tab key`);
}

async function unfolds(page, expect) {
  const last = page.getByText("line 60: 0.017");
  const shown = () => last.evaluate((one) => one.checkVisibility({ contentVisibilityAuto: true }));
  expect(!(await shown()), "the long output is not folded");
  expect(await page.getByText("line 20: 0.050").isVisible(), "nothing of the output is shown");
  await page.getByText("40 more lines").click();
  expect(await shown(), "the long output does not unfold");
}

await testSite(async (visitor) => {
  for (const width of [1440, 360]) {
    for (const scheme of ["light", "dark"]) {
      const options = { width, scheme, permissions: ["clipboard-read", "clipboard-write"] };
      const expect = (good, what) => visitor.expect(good, `${path} (${width}, ${scheme})`, what);
      await visitor.visit(path, options, async (page) => {
        await page.locator(".lines").first().waitFor({ state: "attached" });
        await copies(page, expect);
        await unfolds(page, expect);
        await selects(page, expect);
      });
      await visitor.visit(`${path}#count-L7`, options, async (page) => {
        await page.locator(".lines").first().waitFor({ state: "attached" });
        await lines(page, expect);
      });
    }
  }
  await visitor.visit(path, { javaScript: false }, async (page) => {
    const expect = (good, what) => visitor.expect(good, `${path} without JavaScript`, what);
    await unfolds(page, expect);
  });
  // What a reader looks for with the browser's own search, it finds: a link to the text unfolds it.
  await visitor.visit(`${path}#:~:text=line%2060%3A`, {}, async (page) => {
    const open = await page.locator("#example-count details").evaluate(({ open: is }) => is);
    visitor.expect(open, path, "a search does not find what is folded away");
  });
});
