/** What went wrong in a run or in reading it, with the author's script in which it happened. */
import { make } from "../markup/element.js";
import type { Trouble } from "../run/trouble.js";

export class TroubleBox {
  /** It is there from the start, empty: an alert is heard when its content comes. */
  readonly element = make("div", { role: "alert" });
  #shown = "";

  /** What stopped the run, or, while it goes on, why a reading of it gives no number. */
  show(stopped: Trouble | undefined, reading: Trouble | undefined): void {
    const trouble = stopped ?? reading;
    const shown = trouble === undefined ? "" : `${trouble.message}\n${trouble.source}`;
    if (shown === this.#shown) return;
    this.#shown = shown;
    this.element.className = trouble === undefined ? "" : "lab-trouble";
    const parts = trouble === undefined ? [] : words(trouble, stopped !== undefined);
    this.element.replaceChildren(...parts);
  }
}

function words({ message, cure, source }: Trouble, stopped: boolean): Node[] {
  const what = stopped ? "The simulation stopped" : "This cannot be read";
  const parts: Node[] = [make("p", {}, `${what}: ${message}`)];
  if (source !== "") parts.push(make("pre", { tabindex: 0 }, make("code", {}, source)));
  if (cure !== "") parts.push(make("p", {}, cure));
  if (stopped) parts.push(make("p", {}, "“Back to the start” begins again."));
  return parts;
}
