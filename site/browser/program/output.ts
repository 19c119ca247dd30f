/** What the reader's run prints, as it comes, beside what the lesson's printed. */
import { make } from "../client/element.js";
import { markedParts } from "./marked-lines.js";

export class Output {
  readonly element: HTMLElement;
  readonly #printed = make("samp");
  readonly #complaints = make("samp");
  readonly #scrolled: HTMLElement;
  readonly #complained: HTMLElement;
  readonly #title = make("span");
  #waiting = "";
  #text = "";

  constructor() {
    // What scrolls is in the keyboard's way.
    const attributes = { tabindex: "0", role: "group", "aria-label": "What your run printed" };
    this.#scrolled = make("pre", attributes, this.#printed);
    this.#complained = make("pre", { class: "complaints" }, this.#complaints);
    const label = make("p", { class: "output-label" }, this.#title);
    this.element = make(
      "div",
      { class: "output yours", hidden: "" },
      label,
      this.#scrolled,
      this.#complained,
    );
    this.clear();
  }

  /** Who says what stands here. */
  set title(text: string) {
    this.#title.textContent = text;
  }

  clear(): void {
    this.#waiting = this.#text = "";
    this.#printed.textContent = this.#complaints.textContent = "";
    this.#scrolled.hidden = this.#complained.hidden = true;
    this.element.hidden = true;
  }

  /** A program may print a million pieces: the page has them once a frame. */
  print(text: string): void {
    if (this.#waiting === "") requestAnimationFrame(() => this.#flush());
    this.#waiting += text;
    this.#text += text;
  }

  /** What goes to stderr, and what the compiler says. */
  complain(text: string): void {
    this.#complaints.append(text);
    this.#complained.hidden = this.element.hidden = false;
  }

  /** Marks lines, which count from 1: the first of them, where they are many. */
  mark(numbers: readonly number[]): void {
    this.#flush();
    if (numbers.length === 0) return;
    const shown = markedParts(this.#text, numbers).map(({ text, isMarked }) =>
      isMarked ? make("mark", {}, text) : text,
    );
    this.#printed.replaceChildren(...shown);
  }

  #flush(): void {
    if (this.#waiting === "") return;
    this.#printed.append(this.#waiting);
    this.#waiting = "";
    this.#scrolled.hidden = this.element.hidden = false;
  }
}
