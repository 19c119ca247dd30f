/** A plot in words, for those who hear the page. */
import { make } from "../markup/element.js";
import { fixed } from "../run/fixed.js";
import type { TraceSummary } from "../run/samples.js";

const digits = 4;

export class PlotTable {
  readonly element = make("div", { class: "unseen" });
  readonly #body = make("tbody");

  constructor(ylabel: string) {
    const heads = ["Trace", "Latest", "Lowest", "Highest"];
    const row = make("tr", {}, ...heads.map((head) => make("th", { scope: "col" }, head)));
    const caption = make("caption", {}, `${ylabel}, over the time that is shown`);
    this.element.append(make("table", {}, caption, make("thead", {}, row), this.#body));
  }

  show(summary: readonly TraceSummary[]): void {
    const rows = summary.map(({ label, latest, lowest, highest }) => {
      const values = [latest, lowest, highest].map((value) => make("td", {}, text(value)));
      return make("tr", {}, make("th", { scope: "row" }, label), ...values);
    });
    this.#body.replaceChildren(...rows);
  }
}

function text(value: number | undefined): string {
  return value === undefined ? "none" : fixed(value, digits);
}
