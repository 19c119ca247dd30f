/** What went wrong in a run, with the author's script in which it happened. */
import { make } from "../markup/element.js";
import type { Trouble } from "../run/trouble.js";

export class TroubleBox {
  /** It is there from the start, empty: an alert is heard when its content comes. */
  readonly element = make("div", { role: "alert" });
  #shown: Trouble | undefined;

  show(trouble: Trouble | undefined): void {
    if (trouble === this.#shown) return;
    this.#shown = trouble;
    this.element.className = trouble === undefined ? "" : "lab-trouble";
    this.element.replaceChildren(...(trouble === undefined ? [] : words(trouble)));
  }
}

function words({ message, cure, source }: Trouble): Node[] {
  const parts: Node[] = [make("p", {}, `The simulation stopped: ${message}`)];
  if (source !== "") parts.push(make("pre", { tabindex: 0 }, make("code", {}, source)));
  if (cure !== "") parts.push(make("p", {}, cure));
  parts.push(make("p", {}, "“Back to the start” begins again."));
  return parts;
}
