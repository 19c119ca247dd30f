/** What the reader is to bring about: "not yet", then "there", said once. */
import type { Goal as GoalDescription } from "../lab-module.js";
import { fromHtml, make, setText } from "../markup/element.js";

export class Goal {
  readonly element: HTMLElement;
  readonly #state = make("span", { class: "lab-goal-state", role: "status" }, "not yet");

  constructor({ text }: GoalDescription) {
    const asked = make("div", {}, fromHtml(text));
    this.element = make("div", { class: "lab-goal" }, asked, make("p", {}, "Goal: ", this.#state));
  }

  /** Once reached it stays so, until the lab is as the lesson gave it. */
  show(reached: boolean): void {
    this.element.classList.toggle("reached", reached);
    setText(this.#state, reached ? "there" : "not yet");
  }
}
