// What is said of an answer: right or wrong in words, and what the author has to say of the options
// that were chosen. A status line, so that it is read out too.

import type { Verdict } from "./judge.js";

const words: Readonly<Record<Verdict, string>> = {
  right: "Right.",
  wrong: "Not yet: try again.",
  unclear: "That is not a number: write it as 30, 3e1 or 0.5.",
  none: "",
};

export class VerdictLine {
  readonly element = document.createElement("div");
  readonly #form: HTMLFormElement;
  readonly #words = document.createElement("p");

  constructor(form: HTMLFormElement) {
    this.#form = form;
    this.element.className = "verdict";
    this.element.setAttribute("role", "status");
  }

  /** `hinted` tells that a hint has come up beneath. */
  say(verdict: Verdict, chosen: readonly string[] = [], hinted = false): void {
    this.#form.dataset["verdict"] = verdict;
    this.#words.textContent = words[verdict] + (hinted ? " There is a hint below." : "");
    const remarks = this.#remarksOn(chosen);
    this.element.replaceChildren(...(verdict === "none" ? [] : [this.#words, ...remarks]));
  }

  /** Words that are no verdict. */
  tell(text: string): void {
    this.#form.dataset["verdict"] = "none";
    this.#words.textContent = text;
    this.element.replaceChildren(this.#words);
  }

  /** The remarks stand in the folded answer; here is a copy of those on the chosen options. */
  #remarksOn(chosen: readonly string[]): HTMLElement[] {
    const all = [...this.#form.querySelectorAll<HTMLElement>(":scope > .answer > .remarks > li")];
    const wanted = all.filter((remark) => chosen.includes(remark.dataset["option"] ?? ""));
    if (wanted.length === 0) return [];
    const list = document.createElement("ul");
    list.className = "remarks";
    list.append(...wanted.map((remark) => remark.cloneNode(true)));
    return [list];
  }
}
