// One question, from a form that only shows to one that answers back.
//
// Right or wrong is said in words; a wrong answer brings the hint, a right one the explanation.
// Trying again is free, and so is giving up: the answer is there to be unfolded from the first.
//
// A form tells those around it what became of an answer, by an event "judged" that bubbles; its
// detail is whether the answer was right.

import { noAnswer, recallAnswer, rememberAnswer, type Answer } from "./answers.js";
import { judge } from "./judge.js";
import { reviewed } from "./schedule.js";
import { Sortable } from "./sortable.js";
import { VerdictLine } from "./verdict.js";

export class Question {
  readonly #form: HTMLFormElement;
  readonly #lasting: boolean;
  readonly #verdict: VerdictLine;
  readonly #sortable: Sortable | undefined;
  readonly #hint: HTMLDetailsElement | null;
  readonly #solution: HTMLDetailsElement | null;
  #answer: Answer;

  /** `lasting`: what is done with it is remembered, and what was done restored. */
  constructor(form: HTMLFormElement, lasting = true) {
    this.#form = form;
    this.#lasting = lasting;
    this.#verdict = new VerdictLine(form);
    this.#hint = form.querySelector<HTMLDetailsElement>(":scope > details.hint");
    this.#solution = form.querySelector<HTMLDetailsElement>(":scope > details.answer");
    this.#sortable = this.#makeSortable();
    this.#addButton();

    form.addEventListener("submit", (event) => {
      event.preventDefault();
      this.#answered();
    });
    // An old verdict must not stand beside a new answer.
    form.addEventListener("input", () => this.#verdict.say("none"));
    this.#answer = lasting ? recallAnswer(form.id) : noAnswer;
    this.#restore();
    this.#solution?.addEventListener("toggle", () => {
      this.#keep({ shown: this.#solution?.open ?? false });
    });
  }

  forget(): void {
    this.#answer = noAnswer;
    this.#keep({});
    this.#form.reset();
    this.#sortable?.arrange();
    this.#verdict.say("none");
    this.#unfold();
  }

  #makeSortable(): Sortable | undefined {
    const list = this.#form.querySelector<HTMLUListElement>(":scope > fieldset > ul.items");
    if (!list) return undefined;
    return new Sortable(list, this.#form.id, (place, count) =>
      this.#verdict.tell(`Now in place ${place} of ${count}.`),
    );
  }

  #addButton(): void {
    const row = document.createElement("div");
    row.className = "check";
    const button = document.createElement("button");
    button.className = "plain-button";
    button.textContent = "Check";
    row.append(button, this.#verdict.element);
    this.#form.querySelector(":scope > fieldset")?.after(row);
  }

  /** What is entered, chosen or put in order; empty for nothing. */
  get #given(): string[] {
    const parts = new FormData(this.#form).getAll(this.#form.id);
    return parts
      .filter((part) => typeof part === "string")
      .map((part) => part.trim())
      .filter((part) => part !== "");
  }

  #answered(): void {
    const given = this.#given;
    const verdict = judge(this.#form.dataset, given);
    const hinted = verdict === "wrong" && this.#hint !== null && !this.#answer.missed;
    this.#verdict.say(verdict, given, hinted);
    if (verdict !== "right" && verdict !== "wrong") return;
    const right = verdict === "right";
    this.#keep({
      given,
      missed: this.#answer.missed || !right,
      shown: this.#answer.shown || right,
      review: reviewed(this.#answer.review, right),
    });
    this.#unfold();
    this.#form.dispatchEvent(new CustomEvent("judged", { bubbles: true, detail: right }));
  }

  #restore(): void {
    const { given } = this.#answer;
    for (const field of this.#form.elements) {
      if (!(field instanceof HTMLInputElement) || field.name !== this.#form.id) continue;
      if (field.type === "text") field.value = given[0] ?? "";
      else if (field.type !== "hidden") field.checked = given.includes(field.value);
    }
    if (given.length > 0) this.#sortable?.arrange(given);
    this.#verdict.say(judge(this.#form.dataset, given), given);
    this.#unfold();
  }

  #keep(change: Partial<Answer>): void {
    this.#answer = { ...this.#answer, ...change };
    if (this.#lasting) rememberAnswer(this.#form.id, this.#answer);
  }

  /** Shows the hint once it was earned, and the answer once it was found or asked for. */
  #unfold(): void {
    if (this.#hint) {
      this.#hint.hidden = !this.#answer.missed;
      this.#hint.open = true;
    }
    if (this.#solution) this.#solution.open = this.#answer.shown;
  }
}
