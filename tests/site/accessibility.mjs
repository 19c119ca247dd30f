// axe finds nothing, on a wide light and on a narrow dark screen, with everything unfolded.

import { violations } from "./axe.mjs";
import { pages, testSite } from "./browser.mjs";

async function unfold() {
  for (const details of document.querySelectorAll("details")) details.open = true;
  // The page's own script follows what was unfolded: observers are told after the next frame.
  for (let frame = 0; frame < 2; ++frame) await new Promise(requestAnimationFrame);
}

await testSite(async (visitor) => {
  for (const path of pages) {
    // What a scheme may spoil are colours, and a width sizes and places: so two visits do.
    for (const [scheme, width] of [
      ["light", 1440],
      ["dark", 390],
    ]) {
      await visitor.visit(path, { scheme, width }, async (page) => {
        await page.evaluate(unfold);
        for (const violation of await violations(page)) {
          visitor.complain(`${path} (${scheme}, ${width} px)`, violation);
        }
      });
    }
  }
});
