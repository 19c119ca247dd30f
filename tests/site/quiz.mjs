// A knowledge check answers back: wrong and right in words, with the hint and what the author has to
// say of an option; again for free; remembered, and forgotten.
//
//   node tests/site/quiz.mjs SITE KIND…
//
// The site must have questions of these kinds. They are answered with the keyboard alone; an order is
// also tried with the pointer.

import { pagesWith, testSite } from "./browser.mjs";
import { Trial } from "./question-trial.mjs";

const wanted = process.argv.slice(3);

await testSite(async (visitor) => {
  const met = new Set();
  for (const path of pagesWith('class="quiz')) {
    await visitor.visit(path, { savesData: true }, async (page) => {
      const questions = await page.locator(".quiz .question").all();
      for (const question of questions) {
        const trial = await Trial.of(question, page, path, visitor);
        met.add(trial.kind);
        await trial.run();
      }
      if (questions.length > 0) await tryMemory(visitor, page, path);
    });
  }
  for (const kind of wanted) visitor.expect(met.has(kind), "the site", `has no ${kind} question`);
});

async function tryMemory(visitor, page, path) {
  const verdicts = () => page.locator('.question[data-verdict="right"]').count();
  const visible = (selector) => page.locator(selector).filter({ visible: true }).count();
  const all = await page.locator(".question").count();
  const hints = await page.locator(".question details.hint").count();
  const orders = () => page.locator("li[data-letter]").evaluateAll((l) => l.map((i) => i.id));
  await page.reload();
  const sorted = await orders();
  visitor.expect((await verdicts()) === all, path, "a reload forgets the answers");
  visitor.expect((await visible(".explain")) === all, path, "a reload folds the answers");
  visitor.expect(
    (await visible(".question .hint > div")) === hints,
    path,
    "a reload takes back a hint",
  );
  const forget = page.getByRole("button", { name: "Forget my answers" });
  visitor.expect(
    (await forget.count()) === (await page.locator(".quiz").count()),
    path,
    "a check keeps its answers for good",
  );
  for (const button of await forget.all()) await button.click();
  for (const again of [false, true]) {
    if (again) await page.reload();
    const when = again ? "after a reload" : "at once";
    const forgotten = async (good, what) => visitor.expect(good, path, `${what} ${when}`);
    await forgotten((await verdicts()) === 0, "the answers are not forgotten");
    await forgotten((await visible(".explain")) === 0, "the answers stay unfolded");
    await forgotten((await visible(".question .hint")) === 0, "the hints stay");
    await forgotten(
      (await page.locator(".quiz input:checked").count()) === 0,
      "an option is chosen",
    );
    const shuffled = (await orders()).join() !== sorted.join() || sorted.length === 0;
    await forgotten(shuffled, "the items stay in order");
    const kept = await page.evaluate(() => Object.keys(localStorage));
    const answers = kept.filter((key) => key.startsWith("mjcourse.answer"));
    await forgotten(answers.length === 0, `the browser keeps ${answers}`);
  }
}
