// A docked lab on a narrow screen: once it was scrolled past it is a bar at the foot of the window,
// which unfolds, folds and closes, and covers nothing that has the focus.

import { testSite } from "../browser.mjs";
import { docked, Lab } from "./lab.mjs";

await testSite(async (visitor) => {
  const expect = (good, what) => visitor.expect(good, docked, what);
  await visitor.visit(docked, { width: 390 }, async (page) => {
    const lab = await Lab.live(page, "lab-1");
    const isSheet = () => lab.root.evaluate((root) => root.matches(".sheet"));
    expect(!(await isSheet()), "it is a sheet in its own place");
    const before = await page.evaluate(() => document.body.scrollHeight);

    await scrollPast(page);
    await page.locator("#lab-1.sheet.folded").waitFor();
    const height = await figureHeight(lab);
    expect(height < 60, `the folded sheet is ${height} pixels high`);
    const grown = (await page.evaluate(() => document.body.scrollHeight)) - before;
    expect(grown === height, `the page has grown by ${grown} pixels, not by the bar's ${height}`);

    await tryPlay(page, lab, expect);
    await tryFocus(page, lab, expect);
    await lab.press("Close the sheet");
    expect(!(await isSheet()), "Close does not close");
    await page.evaluate(() => scrollTo(0, 0));
    await lab.settle();
    await scrollPast(page);
    await page.locator("#lab-1.sheet.folded").waitFor();
  });

  // Where there is room it stays beside the text.
  await visitor.visit(docked, { width: 1440 }, async (page) => {
    const lab = await Lab.live(page, "lab-1");
    await page.evaluate(() => scrollTo(0, 500));
    await lab.settle();
    expect(await lab.canvas.isVisible(), "a wide screen has no docked lab");
    expect((await page.locator(".sheet").count()) === 0, "a wide screen has a sheet");
  });
});

async function scrollPast(page) {
  await page.evaluate(() => scrollTo(0, 1800));
}

function figureHeight(lab) {
  return lab.root.locator("> figure").evaluate((figure) => figure.offsetHeight);
}

// Play on the bar unfolds it: what plays is seen.
async function tryPlay(page, lab, expect) {
  await lab.button("Play").first().click();
  await page.locator("#lab-1.sheet:not(.folded)").waitFor();
  await lab.runs();
  const height = await figureHeight(lab);
  expect(height > 200 && height < 700, `the unfolded sheet is ${height} of 900 pixels high`);
  await lab.press("Fold the lab");
  expect(await lab.rests(), "it plays while it is folded");
  await lab.press("Unfold the lab");
  await lab.runs();
}

// Whatever the Tab key reaches in the text is above the sheet.
async function tryFocus(page, lab, expect) {
  const links = page.locator(".prose a");
  // A smooth scroll takes its time.
  await page.evaluate(() => (document.documentElement.style.scrollBehavior = "auto"));
  for (let i = 4; i < 12; ++i) {
    await links.nth(i).focus();
    await page.keyboard.press("Tab");
    await lab.settle();
    const [bottom, sheet] = await page.evaluate(() => [
      document.activeElement.getBoundingClientRect().bottom,
      document.querySelector(".sheet > figure").getBoundingClientRect().top,
    ]);
    expect(bottom <= sheet, `the focus is at ${bottom}, below the sheet's edge at ${sheet}`);
  }
}
