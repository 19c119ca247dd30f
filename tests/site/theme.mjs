// The theme button turns light into dark and back, and the choice outlives the page.

import { pages, testSite } from "./browser.mjs";

const background = () => getComputedStyle(document.documentElement).backgroundColor;

await testSite(async (visitor) => {
  for (const scheme of ["light", "dark"]) {
    const other = scheme === "light" ? "dark" : "light";
    await visitor.visit(pages[0], { scheme }, async (page) => {
      const where = `${pages[0]} (${scheme})`;
      const before = await page.evaluate(background);
      await page.getByRole("button", { name: `Use the ${other} theme` }).click();
      const after = await page.evaluate(background);
      visitor.expect(before !== after, where, `the button leaves the page ${before}`);

      await page.reload();
      visitor.expect((await page.evaluate(background)) === after, where, "a reload forgets it");
      await page.waitForLoadState("networkidle");
      await page.goto(visitor.address(pages.at(-1)));
      visitor.expect(
        (await page.evaluate(background)) === after,
        where,
        "the next page forgets it",
      );

      await page.getByRole("button", { name: `Use the ${scheme} theme` }).click();
      visitor.expect((await page.evaluate(background)) === before, where, "no way back");
    });
  }
});
