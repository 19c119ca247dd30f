/** The numbers of a run, changing in place. Each has the width that its longest text had, so that its
 * neighbours stand still. */
import type { Readout } from "../lab-module.js";
import { make, setText } from "../markup/element.js";

export class Readouts {
  readonly element = make("dl", { class: "readouts" });
  readonly #values: HTMLElement[];

  constructor(readouts: readonly Readout[]) {
    this.#values = readouts.map(({ label, unit }) => {
      const value = make("span", { class: "value" });
      const parts = unit === "" ? [value] : [value, " ", make("span", { class: "unit" }, unit)];
      this.element.append(make("div", {}, make("dt", {}, label), make("dd", {}, ...parts)));
      return value;
    });
  }

  /** As the build prints them. */
  show(printed: readonly string[]): void {
    printed.forEach((text, i) => setText(this.#values[i]!, text));
  }
}
