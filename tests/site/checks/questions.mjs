// Each question of a knowledge check has its answer and explanation folded beneath it, to be opened
// and read without JavaScript too.

// Opens the answer of each question where a reader would press, and folds it again. Gives what is wrong
// of which, and how many questions there are.
function tryQuestions() {
  const wrong = [];
  const isVisible = (element) => {
    const { width, height } = element.getBoundingClientRect();
    return width > 0 && height > 0 && element.checkVisibility({ visibilityProperty: true });
  };
  const questions = [...document.querySelectorAll(".quiz .question")];
  for (const question of questions) {
    const expect = (good, what) => good || wrong.push(`${question.id} ${what}`);
    const details = question.querySelector("details.answer");
    const summary = details.querySelector(":scope > summary");
    const answer = details.querySelector(":scope > .right");
    expect(!isVisible(answer), "shows the answer before it is asked for");
    summary.scrollIntoView({ block: "center", behavior: "instant" });
    const { left, right, top, bottom } = summary.getBoundingClientRect();
    const there = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
    expect(summary.contains(there), "has an answer that cannot be pressed");
    summary.click();
    for (const part of [answer, details.querySelector(":scope > .explain")]) {
      const text = isVisible(part) ? part.innerText.trim() : "";
      expect(text !== "", `cannot be read: ${part.className}`);
    }
    const marks = details.querySelectorAll(":scope > .mark").length;
    expect(marks === 1, "does not say whether the answer is proved");
    summary.click();
  }
  scrollTo({ top: 0, behavior: "instant" });
  return { wrong, count: questions.length };
}

async function look(page, { expect }) {
  const { wrong, count } = await page.evaluate(tryQuestions);
  for (const what of wrong) expect(false, what);
  return count;
}

export const concerns = (html) => html.includes('class="quiz');
export const looks = { light: look, plain: look };

export function conclude({ plain }, { expect }) {
  const count = [...plain.values()].reduce((sum, questions) => sum + questions, 0);
  expect(count > 0, "the site", "there are no questions");
}
