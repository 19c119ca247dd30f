// What the tests of the reader's own pages share.

import { readFileSync } from "node:fs";

const axe = readFileSync(
  new URL("../../site/node_modules/axe-core/axe.min.js", import.meta.url),
  "utf8",
);

// What axe has to say of the page as it is now.
export async function violations(page) {
  await page.evaluate(axe);
  return page.evaluate(async () => {
    const { violations } = await globalThis.axe.run();
    return violations.map(
      ({ id, nodes }) => `${id}: ${nodes[0].target} ${nodes[0].failureSummary}`,
    );
  });
}

// Fills a question's form with `given`: a number, or letters, in order where order is asked.
export async function answer(question, given) {
  const kind = await question.getAttribute("data-kind");
  if (kind === "numeric") await question.getByRole("textbox").fill(given);
  else if (kind === "order") await sort(question, given.split(" "));
  else {
    for (const box of await question.locator("input[value]").all()) {
      const wanted = given.split(" ").includes(await box.getAttribute("value"));
      if (kind === "multi") await box.setChecked(wanted);
      else if (wanted) await box.check();
    }
  }
  await question.getByRole("button", { name: "Check" }).click();
}

export const answerRightly = async (question) =>
  answer(question, await question.getAttribute("data-key"));

async function sort(question, letters) {
  for (const letter of letters.toReversed()) {
    const up = question.locator(`li[data-letter="${letter}"]`).getByRole("button", { name: "up" });
    while ((await up.getAttribute("aria-disabled")) === "false") await up.click();
  }
}
