// A knowledge check answers back: wrong and right in words, again for free, remembered, forgotten.

import { pages, testSite } from "./browser.mjs";

// Every way in which a reader may write the right number.
const spellings = (key) => [key, `${key},0`, `${key}.0`, `${key}e0`, ` ${key} `, `+${key}`];

await testSite(async (visitor) => {
  let count = 0;
  for (const path of pages) {
    await visitor.visit(path, {}, async (page) => {
      for (const question of await page.locator(".quiz .question").all()) {
        ++count;
        await tryQuestion(visitor, page, question, path);
      }
      if ((await page.locator(".quiz").count()) > 0) await tryMemory(visitor, page, path);
    });
  }
  visitor.expect(count > 0, "the site", "there are no questions");
});

async function tryQuestion(visitor, page, question, path) {
  const where = `${path} ${await question.getAttribute("id")}`;
  const { kind, key } = await question.evaluate((form) => ({ ...form.dataset }));
  const status = question.getByRole("status");
  const explanation = question.locator(".explain");
  const says = async (words, after) => {
    const text = await status.innerText();
    visitor.expect(text.includes(words), where, `after ${after} it says "${text}"`);
  };

  if (kind === "numeric") {
    const field = question.getByRole("textbox");
    for (const [given, words] of [
      ["-7", "Not yet"],
      ["−7", "Not yet"],
      ["seven", "not a number"],
    ]) {
      await field.fill(given);
      await field.press("Enter");
      await says(words, given);
    }
    visitor.expect(!(await explanation.isVisible()), where, "a wrong answer opens the explanation");
    for (const spelling of spellings(key)) {
      await field.fill(spelling);
      visitor.expect((await status.innerText()) === "", where, "an old verdict stays");
      await field.press("Enter");
      await says("Right", spelling);
    }
  } else {
    const options = await question.getByRole("radio").all();
    const values = await Promise.all(options.map((option) => option.getAttribute("value")));
    // With the keyboard: the arrow keys go through the options, and Enter checks.
    await options[0].focus();
    await page.keyboard.press("Space");
    for (const value of values) {
      await page.keyboard.press("Enter");
      await says(value === key ? "Right" : "Not yet", value);
      await page.keyboard.press("ArrowDown");
    }
    await question.locator(`input[value="${key}"]`).check();
    await question.getByRole("button", { name: "Check" }).click();
    await says("Right", key);
  }
  visitor.expect(await explanation.isVisible(), where, "a right answer explains nothing");
}

async function tryMemory(visitor, page, path) {
  const verdicts = () => page.locator('.question[data-verdict="right"]').count();
  const all = await page.locator(".question").count();
  await page.waitForLoadState("networkidle"); // what a reload breaks off counts as failed
  await page.reload();
  visitor.expect((await verdicts()) === all, path, "a reload forgets the answers");
  await page.getByRole("button", { name: "Forget my answers" }).click();
  visitor.expect((await verdicts()) === 0, path, "the answers are not forgotten");
  await page.waitForLoadState("networkidle");
  await page.reload();
  visitor.expect((await verdicts()) === 0, path, "forgotten answers come back");
  visitor.expect((await page.locator("input:checked").count()) === 0, path, "an option is chosen");
}
