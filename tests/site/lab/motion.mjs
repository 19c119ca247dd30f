// Nothing moves unless the reader moved it: a lab starts with Play alone, stands still while it cannot
// be seen, and goes on afterwards only if the reader had it playing.

import { testSite } from "../browser.mjs";
import { fourLabs, Lab } from "./lab.mjs";

await testSite(async (visitor) => {
  await visitor.visit(fourLabs, { reducedMotion: "reduce" }, async (page) => {
    const lab = await Lab.live(page, "lab-1");
    const expect = (good, what) => visitor.expect(good, fourLabs, what);
    expect(await lab.rests(), "a lab starts by itself");
    expect((await lab.seconds()) === 0, "a lab started by itself");
    await lab.canvas.focus();
    await page.keyboard.press("v");
    const first = await lab.picture();
    await page.waitForTimeout(300);
    expect((await lab.picture()) === first, "the camera goes on moving");
    const animations = await page.evaluate(() => document.getAnimations().length);
    expect(animations === 0, `${animations} animations run`);

    await lab.button("Play").first().click();
    await lab.runs();
    await tryAway(lab, expect);
    await tryHidden(lab, expect);
    await tryPaused(lab, expect);
  });
});

// Out of the window it stands still: the next lab, far below, is looked at for a while.
async function tryAway(lab, expect) {
  await lab.page.evaluate(() => scrollTo(0, document.body.scrollHeight));
  await lab.settle();
  expect(await lab.rests(), "it plays where it cannot be seen");
  await lab.root.scrollIntoViewIfNeeded();
  await lab.runs();
}

// A tab that is not in front. Headless browsers have none, so the page is told so.
async function tryHidden(lab, expect) {
  const turn = (state) =>
    lab.page.evaluate((visibilityState) => {
      Object.defineProperty(document, "visibilityState", {
        value: visibilityState,
        configurable: true,
      });
      document.dispatchEvent(new Event("visibilitychange"));
    }, state);
  await turn("hidden");
  await lab.settle();
  expect(await lab.rests(), "it plays in a tab that is hidden");
  await turn("visible");
  await lab.runs();
}

async function tryPaused(lab, expect) {
  await lab.press("Pause");
  await lab.page.evaluate(() => scrollTo(0, document.body.scrollHeight));
  await lab.settle();
  await lab.root.scrollIntoViewIfNeeded();
  await lab.settle();
  expect(await lab.rests(), "what was paused goes on when it is seen again");
}
