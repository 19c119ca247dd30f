// The review draws the questions of opened lessons, one at a time, each on its day: after right answers
// it comes again in 1, 3, 7 and 21 days, after a wrong one it begins anew.
//
//   node tests/site/review.mjs SITE

import { readFileSync, globSync } from "node:fs";
import { join } from "node:path";

import { violations } from "./axe.mjs";
import { folder, pages, testSite } from "./browser.mjs";
import { answer, answerRightly } from "./learner.mjs";

const path = "review.html";
const asked = (page) =>
  (readFileSync(join(folder, page), "utf8").match(/<form class="q/g) ?? []).length;
const lesson = pages.find((page) => page !== path && asked(page) > 1);
const questions = asked(lesson);

class Review {
  constructor(page, visitor, expect) {
    Object.assign(this, { page, visitor, expect });
    this.question = page.locator(".deck form.question");
    this.due = page.locator(".due");
    this.next = page.locator(".next-card");
  }

  async go(to) {
    await this.page.waitForLoadState("networkidle"); // what is broken off counts as failed
    await this.page.goto(this.visitor.address(to));
  }

  // Opens the page, which is to begin with `words`.
  async open(words) {
    await this.go(path);
    await this.says(words);
  }

  async says(words) {
    const text = await this.due.innerText();
    this.expect(text.startsWith(words), `it says "${text}", not "${words}"`);
  }

  // Answers all that is due today.
  async answerAll() {
    while ((await this.question.count()) > 0) {
      await answerRightly(this.question);
      await this.next.click();
    }
  }

  async run() {
    await this.oneCard();
    await this.answerAll();
    await this.says("Nothing is due today. The next question comes on Saturday");
    for (const days of [1, 3, 7, 21]) {
      await this.wait(days - 1);
      await this.open("Nothing is due today.");
      await this.wait(1);
      await this.open(`${questions} due today, 0 later.`);
      await this.answerAll();
    }
    await this.wait(21);
    await this.open(`${questions} due today`);
    await this.missed();
    await this.wait(1);
    await this.open("1 due today");
  }

  // The first card: it says where it is from, and that its answer is proved; and a right answer
  // leaves the lesson's own form as it was.
  async oneCard() {
    const id = await this.question.getAttribute("id");
    const link = await this.page.locator(".source a").getAttribute("href");
    this.expect(link === `${lesson}#${id}`, `the question is said to be from ${link}`);
    await answerRightly(this.question);
    await this.says(`${questions - 1} due today, 1 later.`);
    this.expect((await this.question.locator(".mark").count()) === 1, "no word on its proof");
    this.expect(await this.question.locator(".explain").isVisible(), "nothing is explained");
    const given = await this.page.evaluate(() =>
      Object.keys(localStorage)
        .filter((key) => key.startsWith("mjcourse.answer"))
        .map((key) => JSON.parse(localStorage[key]).given.length),
    );
    this.expect(given.join() === "0", `it touches the lesson's answers: ${given}`);
    await this.next.click();
    const focused = await this.due.evaluate((due) => due === document.activeElement);
    this.expect(focused, "the focus is lost with the button");
  }

  // One wrong, though it is right at the second try; one looked up; the others right.
  async missed() {
    const wrong = (await this.question.getAttribute("data-kind")) === "numeric" ? "-98765" : "";
    if (wrong) await answer(this.question, wrong);
    else await this.question.locator(".answer > summary").click();
    this.expect((await this.next.count()) === 1, "a wrong answer does not count");
    await answerRightly(this.question);
    await this.next.click();
    await this.answerAll();
  }

  async wait(days) {
    const now = await this.page.evaluate(() => Date.now());
    await this.page.clock.setSystemTime(now + days * 24 * 3600 * 1000);
  }
}

await testSite(async (visitor) => {
  const expect = (good, what) => visitor.expect(good, path, what);
  const [script] = globSync("review/*.js", { cwd: folder });
  const all = pages.map(asked).reduce((sum, count) => sum + count, 0);
  const there = readFileSync(join(folder, script), "utf8").match(/<form class=\\"q/g).length;
  expect(there === all, `of ${all} questions, ${there} come to it`);

  for (const scheme of ["light", "dark"]) {
    const before = (page) => page.clock.install({ time: new Date("2026-03-27T09:00") });
    await visitor.visit(path, { scheme, before, timezoneId: "Europe/Berlin" }, async (page) => {
      const review = new Review(page, visitor, expect);
      await review.open("Nothing to review yet");
      await review.go(lesson);
      await review.open(`${questions} due today, 0 later.`);
      for (const violation of await violations(page)) expect(false, violation);
      await review.run();
    });
  }
});
