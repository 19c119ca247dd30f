// What axe finds in a page as it is now. Beside its own choice of rules it looks at the size of what is
// pressed (WCAG 2.2, 2.5.8).

import { readFileSync } from "node:fs";

const axe = readFileSync(
  new URL("../../site/node_modules/axe-core/axe.min.js", import.meta.url),
  "utf8",
);

// A line for each rule that is broken, and below it up to three places.
export async function violations(page) {
  const there = await page.evaluate(() => globalThis.axe !== undefined);
  if (!there) await page.evaluate(axe);
  return page.evaluate(async () => {
    const { violations } = await globalThis.axe.run({
      resultTypes: ["violations"], // of all else, a summary will do
      rules: { "target-size": { enabled: true } },
    });
    return violations.map(({ id, help, nodes }) => {
      const places = nodes
        .slice(0, 3)
        .map((node) => `${node.target}\n      ${node.failureSummary}`);
      return `${id}: ${help} (${nodes.length})\n    ${places.join("\n    ")}`;
    });
  });
}
