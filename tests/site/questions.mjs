// Each question of a knowledge check has its answer and explanation folded beneath it, to be opened
// and read without JavaScript too.

import { pagesWith, testSite } from "./browser.mjs";

await testSite(async (visitor) => {
  let count = 0;
  for (const javaScript of [true, false]) {
    for (const path of pagesWith('class="quiz')) {
      await visitor.visit(path, { javaScript, savesData: true }, async (page) => {
        for (const question of await page.locator(".quiz .question").all()) {
          ++count;
          const where = `${path} ${await question.getAttribute("id")}`;
          const answer = question.locator("details.answer > .right").first();
          const explanation = question.locator("details.answer > .explain");
          visitor.expect(
            !(await answer.isVisible()),
            where,
            "the answer shows before it is asked for",
          );
          await question.locator("details.answer > summary").click();
          for (const part of [answer, explanation]) {
            const text = (await part.isVisible()) ? (await part.innerText()).trim() : "";
            visitor.expect(
              text !== "",
              where,
              `cannot be read: ${await part.getAttribute("class")}`,
            );
          }
          visitor.expect(
            (await question.locator("details.answer > .mark").count()) === 1,
            where,
            "does not say whether the answer is proved",
          );
        }
      });
    }
  }
  visitor.expect(count > 0, "the site", "there are no questions");
});
