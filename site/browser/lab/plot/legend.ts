/** What each line of a plot is, with its latest value. */
import { make, setText } from "../markup/element.js";
import { fixed } from "../run/fixed.js";
import { dashes, ghostDash } from "./dashes.js";

const digits = 3;
const svg = "http://www.w3.org/2000/svg";

export class Legend {
  readonly element = make("ul", { class: "plot-legend" });
  /** A piece of each line, in its colour. */
  readonly lines: readonly SVGElement[];
  readonly #values: HTMLElement[];

  /** The first `traces` labels are the plot's own, the others its ghost's. */
  constructor(labels: readonly string[], traces: number) {
    this.lines = labels.map((_, i) => sample(i % traces, i >= traces));
    this.#values = labels.map(() => make("span", { class: "plot-value" }));
    labels.forEach((label, i) => {
      this.element.append(make("li", {}, picture(this.lines[i]!), label, this.#values[i]!));
    });
  }

  show(latest: readonly (number | null | undefined)[]): void {
    latest.forEach((value, i) => {
      setText(this.#values[i]!, typeof value === "number" ? fixed(value, digits) : "–");
    });
  }
}

function sample(trace: number, ghost: boolean): SVGElement {
  const line = document.createElementNS(svg, "line");
  const ends = { x1: 0, x2: 28, y1: 4, y2: 4 };
  for (const [name, value] of Object.entries(ends)) line.setAttribute(name, String(value));
  line.setAttribute("class", `trace-${trace + 1}`);
  line.setAttribute("stroke-width", ghost ? "1.25" : "2");
  line.setAttribute("stroke-dasharray", (ghost ? ghostDash : dashes[trace]!).join(" "));
  return line;
}

function picture(line: SVGElement): SVGElement {
  const svgElement = document.createElementNS(svg, "svg");
  svgElement.setAttribute("viewBox", "0 0 28 8");
  svgElement.setAttribute("aria-hidden", "true");
  svgElement.append(line);
  return svgElement;
}
