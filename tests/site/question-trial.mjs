// One question of a knowledge check, answered wrong and right in every way that its kind allows.
//
// Enter at Trial.of(…).run().

// Every way in which a reader may write the right number.
const spellings = (key) => [
  ...new Set([
    key,
    key.replace(".", ","),
    key.replace("-", "−"),
    key.includes(".") ? `${key}0` : `${key},0`,
    `${key}e0`,
    `${Number(key) * 10}e-1`,
    ` ${key} `,
    key.startsWith("-") ? key : `+${key}`,
  ]),
];

// What a form says of its question.
function read(question) {
  return question.evaluate((form) => ({
    id: form.id,
    ...form.dataset,
    remarks: [...form.querySelectorAll(".answer .remarks > li")].map((r) => r.dataset.option),
  }));
}

export class Trial {
  // It complains by `complain(good, what)`.
  static async of(question, page, complain) {
    return new Trial(complain, page, question, await read(question));
  }

  constructor(complain, page, question, { id, kind, key, tolerance, remarks }) {
    Object.assign(this, { complain, page, question, id, kind, key, remarks });
    this.tolerance = Number(tolerance);
    this.status = question.getByRole("status");
    this.explanation = question.locator(".explain");
    this.hint = question.locator("details.hint > div");
  }

  expect(good, what) {
    this.complain(good, `${this.id}: ${what}`);
  }

  async says(words, after) {
    const text = await this.status.innerText();
    this.expect(text.includes(words), `after ${after} it says "${text}", not "${words}"`);
  }

  async run() {
    this.hints = (await this.hint.count()) > 0;
    this.expect(!this.hints || !(await this.hint.isVisible()), "the hint shows from the first");
    await this[this.kind]();
    this.expect(await this.explanation.isVisible(), "a right answer explains nothing");
    await this.giveUp();
  }

  // Once the first wrong answer was given.
  async missed() {
    this.expect(!(await this.explanation.isVisible()), "a wrong answer opens the explanation");
    if (!this.hints) return;
    await this.says("There is a hint below", "the first wrong answer");
    this.expect(await this.hint.isVisible(), "a wrong answer brings no hint");
  }

  async numeric() {
    const field = this.question.getByRole("textbox");
    const right = Number(this.key);
    const enter = async (text, words) => {
      await field.fill(text);
      this.expect((await this.status.innerText()) === "", "an old verdict stays");
      await field.press("Enter");
      await this.says(words, `"${text}"`);
    };
    await enter("seven", "not a number");
    await enter("-123456", "Not yet");
    await this.missed();
    await enter("−123456", "Not yet");
    await enter(String(right + 1.01 * this.tolerance + 1e-6), "Not yet");
    for (const spelling of spellings(this.key)) await enter(spelling, "Right");
    await enter(String(right - 0.99 * this.tolerance), "Right");
    await this.worded(field);
  }

  // The tolerance and the unit are in the field's name and description.
  async worded(field) {
    const label = await field.evaluate((input) => input.labels[0].innerText);
    const within = this.tolerance > 0;
    this.expect(label.includes("to within") === within, `the field is called "${label}"`);
    const unit = await this.question.locator(".entry .unit").count();
    const described = await field.getAttribute("aria-describedby");
    this.expect((described !== null) === unit > 0, "the unit does not describe the field");
  }

  // The arrow keys go through the options, and Enter checks.
  async mcq() {
    const options = await this.letters("radio");
    await this.question.getByRole("radio").first().focus();
    await this.page.keyboard.press("Space");
    let wrong = 0;
    for (const option of options) {
      await this.page.keyboard.press("Enter");
      const right = option === this.key;
      await this.says(right ? "Right" : "Not yet", option);
      await this.remarked([option]);
      if (!right && ++wrong === 1 && option === "A") await this.missed();
      await this.page.keyboard.press("ArrowDown");
    }
    await this.question.locator(`input[value="${this.key}"]`).press("Space");
    await this.check();
    await this.says("Right", this.key);
  }

  // Tab goes through the options, the space bar chooses.
  async multi() {
    const options = await this.letters("checkbox");
    const right = this.key.split(" ");
    const first = this.question.getByRole("checkbox").first();
    const choose = async (chosen, words) => {
      await first.focus();
      for (const option of options) {
        const box = this.question.locator(`input[value="${option}"]`);
        if ((await box.isChecked()) !== chosen.includes(option)) {
          await this.page.keyboard.press("Space");
        }
        await this.page.keyboard.press("Tab");
      }
      await this.page.keyboard.press("Enter"); // the button
      await this.says(words, chosen.join(" "));
      await this.remarked(words === "" ? [] : chosen);
    };
    await choose([], "");
    await choose(
      options.filter((option) => !right.includes(option)),
      "Not yet",
    );
    await this.missed();
    await choose(right.slice(1), right.length === 1 ? "" : "Not yet");
    if (options.length > right.length) await choose(options, "Not yet");
    await choose(right, "Right");
  }

  async order() {
    const right = this.key.split(" ");
    await this.check();
    await this.says("Not yet", "the order in which it is shown");
    await this.missed();
    await this.sortWithKeys(right);
    await this.check();
    await this.says("Right", right.join(" "));
    await this.drag(0, right.length - 1);
    await this.says(`in place ${right.length} of ${right.length}`, "a drag");
    await this.check();
    await this.says("Not yet", "a drag");
    await this.drag(right.length - 1, 0);
    await this.check();
    await this.says("Right", "a drag back");
  }

  // Lifts each item to its place, from the top, pressing its button again and again.
  async sortWithKeys(right) {
    for (const [place, letter] of right.entries()) {
      const item = this.question.locator(`li[data-letter="${letter}"]`);
      const button = item.getByRole("button", { name: "Move up" });
      const text = (await item.locator(".item").innerText()).slice(0, 4);
      const name = await button.evaluate((b) =>
        b
          .getAttribute("aria-labelledby")
          .split(" ")
          .map((id) => document.getElementById(id))
          .map((e) => e.getAttribute("aria-label") ?? e.innerText)
          .join(" "),
      );
      this.expect(name.startsWith(`Move up ${text}`), `a button is called "${name}"`);
      await button.focus();
      for (let at = (await this.orderNow()).indexOf(letter); at > place; --at) {
        await this.page.keyboard.press("Space");
        await this.says(`Now in place ${at} of ${right.length}`, `lifting ${letter}`);
        const kept = await button.evaluate((b) => b === document.activeElement);
        this.expect(kept, "a button that was pressed loses the focus");
      }
    }
    this.expect((await this.orderNow()).join() === right.join(), "the items are not in order");
    // At the top there is no way up.
    const top = this.question.getByRole("button", { name: "Move up" }).first();
    this.expect((await top.getAttribute("aria-disabled")) === "true", "the top item can rise");
    await top.press("Space");
    this.expect((await this.orderNow()).join() === right.join(), "the top item rises");
  }

  // Drags the item at one place to another, by its grip.
  async drag(from, to) {
    const box = async (place) => this.question.locator(".items > li").nth(place).boundingBox();
    await this.question.locator(".items").scrollIntoViewIfNeeded();
    const grip = await this.question.locator(".grip").nth(from).boundingBox();
    const target = await box(to);
    const x = grip.x + grip.width / 2;
    await this.page.mouse.move(x, grip.y + grip.height / 2);
    await this.page.mouse.down();
    const y = to > from ? target.y + target.height - 2 : target.y + 2;
    await this.page.mouse.move(x, y, { steps: 12 });
    await this.page.mouse.up();
  }

  orderNow() {
    return this.question
      .locator(".items > li")
      .evaluateAll((items) => items.map((item) => item.dataset.letter));
  }

  async letters(role) {
    const options = await this.question.getByRole(role).all();
    return Promise.all(options.map((option) => option.getAttribute("value")));
  }

  check() {
    return this.question.getByRole("button", { name: "Check" }).click();
  }

  // What is said beside a choice is what the author has to say of the chosen options.
  async remarked(chosen) {
    const said = await this.status
      .locator(".remarks > li")
      .evaluateAll((list) => list.map((remark) => remark.dataset.option));
    const due = this.remarks.filter((option) => chosen.includes(option));
    this.expect(said.join() === due.join(), `for ${chosen} it remarks on ${said}, not ${due}`);
  }

  // The answer folds, and unfolds for who asks for it.
  async giveUp() {
    const summary = this.question.locator("details.answer > summary");
    await summary.press("Enter");
    this.expect(!(await this.explanation.isVisible()), "the answer does not fold");
    const text = await summary.innerText();
    this.expect(text === "Show the answer", `the folded answer is called "${text}"`);
    await summary.press("Enter");
    this.expect(await this.explanation.isVisible(), "the answer does not unfold");
    // The form is told of it, to remember it, a moment later.
    await summary.evaluate(
      () => new Promise((done) => requestAnimationFrame(() => setTimeout(done))),
    );
  }
}
