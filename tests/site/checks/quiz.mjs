// A knowledge check answers back: wrong and right in words, with the hint and what the author has to
// say of an option; again for free; remembered, and forgotten. Each question is answered with the
// keyboard alone; an order is also tried with the pointer. A site has every kind of question.

import { Trial } from "../question-trial.mjs";

const kinds = ["numeric", "mcq", "multi", "order"];

async function tryMemory(page, expect) {
  const verdicts = () => page.locator('.question[data-verdict="right"]').count();
  const visible = (selector) => page.locator(selector).filter({ visible: true }).count();
  const all = await page.locator(".question").count();
  const hints = await page.locator(".question details.hint").count();
  const orders = () => page.locator("li[data-letter]").evaluateAll((l) => l.map((i) => i.id));
  await page.reload();
  const sorted = await orders();
  expect((await verdicts()) === all, "a reload forgets the answers");
  expect((await visible(".explain")) === all, "a reload folds the answers");
  expect((await visible(".question .hint > div")) === hints, "a reload takes back a hint");
  const forget = page.getByRole("button", { name: "Forget my answers" });
  const checks = await page.locator(".quiz").count();
  expect((await forget.count()) === checks, "a check keeps its answers for good");
  for (const button of await forget.all()) await button.click();
  for (const again of [false, true]) {
    if (again) await page.reload();
    const forgotten = (good, what) =>
      expect(good, `${what} ${again ? "after a reload" : "at once"}`);
    forgotten((await verdicts()) === 0, "the answers are not forgotten");
    forgotten((await visible(".explain")) === 0, "the answers stay unfolded");
    forgotten((await visible(".question .hint")) === 0, "the hints stay");
    forgotten((await page.locator(".quiz input:checked").count()) === 0, "an option is chosen");
    const shuffled = (await orders()).join() !== sorted.join() || sorted.length === 0;
    forgotten(shuffled, "the items stay in order");
    const kept = await page.evaluate(() => Object.keys(localStorage));
    const answers = kept.filter((key) => key.startsWith("mjcourse.answer"));
    forgotten(answers.length === 0, `the browser keeps ${answers}`);
  }
}

// Gives the kinds of its questions.
async function saver(page, { expect }) {
  const met = new Set();
  for (const question of await page.locator(".quiz .question").all()) {
    const trial = await Trial.of(question, page, expect);
    met.add(trial.kind);
    await trial.run();
  }
  if (met.size > 0) await tryMemory(page, expect);
  return [...met];
}

export const concerns = (html) => html.includes('class="quiz');
export const looks = { saver };

export function conclude({ saver: kindsOfPages }, { expect }) {
  const met = new Set([...kindsOfPages.values()].flat());
  for (const kind of kinds) expect(met.has(kind), "the site", `has no ${kind} question`);
}
