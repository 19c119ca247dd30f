/** What of the overlays is shown: a checkbox for each that the lesson offers. */
import { make } from "../markup/element.js";

export class Overlays {
  readonly element = make("fieldset", { class: "lab-shown" }, make("legend", {}, "show"));
  readonly #boxes = new Map<string, HTMLInputElement>();

  constructor(names: readonly string[], show: (name: string, on: boolean) => void) {
    for (const name of names) {
      const box = make("input", { type: "checkbox" });
      box.addEventListener("change", () => show(name, box.checked));
      this.#boxes.set(name, box);
      this.element.append(make("label", { class: "lab-check" }, box, name.replaceAll("-", " ")));
    }
    this.element.hidden = names.length === 0;
  }

  show(shown: ReadonlySet<string>): void {
    for (const [name, box] of this.#boxes) box.checked = shown.has(name);
  }
}
