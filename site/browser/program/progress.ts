/** How far the compiler is, as a bar and in words. A stage is told once, and its share only shown. */
import { make } from "../client/element.js";
import type { Stage } from "../cpp/messages.js";

const stages: Readonly<Record<Stage, string>> = {
  download: "Fetching the compiler…",
  "compile-tools": "Making the compiler ready…",
  header: "Making the headers ready, which is done once…",
};

export class ProgressBar {
  readonly element = make("progress", {
    max: "1",
    hidden: "",
    "aria-label": "Loading the compiler",
  });
  readonly #say: (text: string) => void;
  #stage: Stage | undefined;

  constructor(say: (text: string) => void) {
    this.#say = say;
  }

  readonly show = (stage: Stage, done: number, total: number): void => {
    this.element.hidden = false;
    if (total > 0) this.element.value = done / total;
    else this.element.removeAttribute("value");
    if (stage === this.#stage) return;
    this.#stage = stage;
    this.#say(stages[stage]);
  };

  hide(): void {
    this.element.hidden = true;
    this.#stage = undefined;
  }
}
