// One question, from a form that only shows to one that answers back.
//
// Right or wrong is said in words, in a status line; a right answer opens the explanation. Trying
// again is free. The form's data-key is what is right, data-tolerance by how much a number may differ.

import { recallAnswer, rememberAnswer } from "./answers.js";
import { parseNumber } from "./number.js";

type Verdict = "right" | "wrong" | "unclear" | "none";

const words: Readonly<Record<Verdict, string>> = {
  right: "Right.",
  wrong: "Not yet: try again.",
  unclear: "That is not a number: write it as 30, 3e1 or 0.5.",
  none: "",
};

export class Question {
  readonly #form: HTMLFormElement;
  readonly #status = document.createElement("p");

  constructor(form: HTMLFormElement) {
    this.#form = form;
    const row = document.createElement("div");
    row.className = "check";
    const button = document.createElement("button");
    button.textContent = "Check";
    this.#status.className = "verdict";
    this.#status.setAttribute("role", "status");
    row.append(button, this.#status);
    form.querySelector("fieldset")?.after(row);

    form.addEventListener("submit", (event) => {
      event.preventDefault();
      this.#answered();
    });
    // An old verdict must not stand beside a new answer.
    form.addEventListener("input", () => this.#say("none"));
    const before = recallAnswer(form.id);
    if (before !== null) this.#restore(before);
  }

  forget(): void {
    rememberAnswer(this.#form.id, null);
    this.#form.reset();
    this.#say("none");
    this.#explain(false);
  }

  /** What is entered or chosen; "" for nothing. */
  get #given(): string {
    const given = new FormData(this.#form).get(this.#form.id);
    return typeof given === "string" ? given.trim() : "";
  }

  #judge(given: string): Verdict {
    if (given === "") return "none";
    const { kind, key, tolerance } = this.#form.dataset;
    if (kind !== "numeric") return given === key ? "right" : "wrong";
    const value = parseNumber(given);
    if (value === undefined) return "unclear";
    // Decimals are not exact in binary: a tolerance of 0 still allows for that.
    const right = Number(key);
    const allowed = Number(tolerance) + 1e-12 * Math.max(1, Math.abs(right));
    return Math.abs(value - right) <= allowed ? "right" : "wrong";
  }

  #answered(): void {
    const given = this.#given;
    const verdict = this.#judge(given);
    this.#say(verdict);
    if (verdict === "right" || verdict === "wrong") rememberAnswer(this.#form.id, given);
    if (verdict === "right") this.#explain(true);
  }

  #restore(given: string): void {
    const field = this.#form.elements.namedItem(this.#form.id);
    if (field instanceof HTMLInputElement || field instanceof RadioNodeList) field.value = given;
    this.#say(this.#judge(given));
  }

  #say(verdict: Verdict): void {
    this.#form.dataset["verdict"] = verdict;
    this.#status.textContent = words[verdict];
  }

  #explain(open: boolean): void {
    const answer = this.#form.querySelector("details");
    if (answer) answer.open = open;
  }
}
