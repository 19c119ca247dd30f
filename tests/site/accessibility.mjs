// axe finds nothing, in either scheme, on a wide and on a narrow screen, with everything unfolded.

import { violations } from "./axe.mjs";
import { pages, testSite } from "./browser.mjs";

async function unfold() {
  for (const details of document.querySelectorAll("details")) details.open = true;
  // The page's own script follows what was unfolded: observers are told after the next frame.
  for (let frame = 0; frame < 2; ++frame) await new Promise(requestAnimationFrame);
}

await testSite(async (visitor) => {
  for (const path of pages) {
    for (const scheme of ["light", "dark"]) {
      for (const width of [1440, 390]) {
        await visitor.visit(path, { scheme, width }, async (page) => {
          await page.evaluate(unfold);
          for (const violation of await violations(page)) {
            visitor.complain(`${path} (${scheme}, ${width} px)`, violation);
          }
        });
      }
    }
  }
});
