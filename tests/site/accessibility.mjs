// axe finds nothing, in either scheme, on a wide and on a narrow screen, with everything unfolded.

import { readFileSync } from "node:fs";

import { pages, testSite } from "./browser.mjs";

const axe = readFileSync(
  new URL("../../site/node_modules/axe-core/axe.min.js", import.meta.url),
  "utf8",
);

async function violations() {
  for (const details of document.querySelectorAll("details")) details.open = true;
  // The page's own script follows what was unfolded: observers are told after the next frame.
  for (let frame = 0; frame < 2; ++frame) await new Promise(requestAnimationFrame);
  const { violations } = await globalThis.axe.run();
  return violations.map(({ id, help, nodes }) => {
    const places = nodes.slice(0, 3).map((node) => `${node.target}\n      ${node.failureSummary}`);
    return `${id}: ${help} (${nodes.length})\n    ${places.join("\n    ")}`;
  });
}

await testSite(async (visitor) => {
  for (const path of pages) {
    for (const scheme of ["light", "dark"]) {
      for (const width of [1440, 390]) {
        await visitor.visit(path, { scheme, width }, async (page) => {
          await page.evaluate(axe);
          for (const violation of await page.evaluate(violations)) {
            visitor.complain(`${path} (${scheme}, ${width} px)`, violation);
          }
        });
      }
    }
  }
});
