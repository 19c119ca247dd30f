// A term shows what it means beside it: to the pointer, which may go there and rest, and to the
// keyboard, until Escape. The words are those that the browser shows where there is no script.

import { testSite } from "./browser.mjs";

const path = "1-basics/1.1-references.html";

await testSite(async (visitor) => {
  await visitor.visit(path, { javaScript: false }, async (page) => {
    visitor.expect(
      (await page.locator("a.term").first().getAttribute("title")) !== "",
      path,
      "no title",
    );
  });
  for (const [width, scheme] of [
    [1440, "light"],
    [360, "dark"],
  ]) {
    await visitor.visit(path, { width, scheme }, async (page) => {
      const where = `${path} (${width} px)`;
      const expect = (good, what) => visitor.expect(good, where, what);
      const card = page.locator(".term-card");
      const shown = () => card.isVisible();
      const term = page.locator("main table a.term").first();
      const meaning = await term.getAttribute("title");

      await term.scrollIntoViewIfNeeded();
      await page.waitForTimeout(100); // what scrolls hides the card
      await term.hover();
      await card.waitFor();
      expect((await card.innerText()) === meaning, "the card says something else");
      expect((await term.getAttribute("title")) === null, "the browser says it as well");
      expect((await term.getAttribute("aria-describedby")) === "term-card", "nobody is told of it");
      const box = await card.boundingBox();
      expect(box.x >= 0 && box.x + box.width <= width, "the card leaves the window");

      await page.mouse.move(box.x + 20, box.y + 20, { steps: 5 });
      await page.waitForTimeout(400);
      expect(await shown(), "the card goes when the pointer comes to it");
      await page.mouse.move(1, 1);
      await card.waitFor({ state: "hidden" });
      expect((await term.getAttribute("aria-describedby")) === null, "what is hidden is told of");

      await term.evaluate((link) => link.focus({ focusVisible: true }));
      expect(await shown(), "focus opens no card");
      await page.keyboard.press("Escape");
      expect(!(await shown()), "Escape leaves the card");
      await page.keyboard.press("Shift+Tab");
      await page.keyboard.press("Tab");
      expect(await shown(), "the keyboard opens no card");
      await page.keyboard.press("Tab");
      expect((await card.innerText()) !== meaning || !(await shown()), "the card stays behind");
    });
  }
});
