/** A plot of the page that shows what the reader's run reported, until it is reset. */
import type { Drawing } from "../../press/script/plot/drawing.js";
import type { Columns } from "../../press/script/plot/written.js";

const plots = new WeakMap<HTMLElement, RedrawnPlot>();

export class RedrawnPlot {
  readonly #element: HTMLElement;
  /** What the build drew, of each drawing. */
  readonly #recorded: ReadonlyMap<SVGElement, string>;
  readonly #source: HTMLElement | null;
  readonly #recordedSource: string;
  #spec: Promise<string> | undefined;
  /** Of the latest run: what is drawn for an earlier one comes too late. */
  #run = 0;

  /** `element` is a plot as site/press/templates/plot.hbs writes it. */
  static of(element: HTMLElement): RedrawnPlot {
    const known = plots.get(element) ?? new RedrawnPlot(element);
    plots.set(element, known);
    return known;
  }

  private constructor(element: HTMLElement) {
    this.#element = element;
    const drawings = [...element.querySelectorAll<SVGElement>("svg[role]")];
    this.#recorded = new Map(drawings.map((drawing) => [drawing, drawing.outerHTML]));
    this.#source = element.querySelector("figcaption > .plot-source:last-child");
    this.#recordedSource = this.#source?.innerHTML ?? "";
  }

  /** Draws what the reader's run reported, of all `tables` by their names. */
  async show(tables: ReadonlyMap<string, Columns | string>): Promise<void> {
    const run = ++this.#run;
    try {
      const name = this.#element.dataset["table"]!;
      const columns = tables.get(name);
      if (columns === undefined) throw new Error(`your run reported no table “${name}”`);
      if (typeof columns === "string") throw new Error(`of your run’s table “${name}”, ${columns}`);
      this.#spec ??= fetchText(this.#element.dataset["spec"]!);
      const [spec, { drawPlot }] = await Promise.all([this.#spec, import("./plot-drawing.js")]);
      const { wide, narrow } = await drawPlot(spec, columns, this.#element.id);
      if (run !== this.#run) return;
      for (const drawing of this.#recorded.keys()) {
        const isNarrow = drawing.parentElement!.matches(".plot-narrow");
        redraw(drawing, isNarrow ? (narrow ?? wide) : wide);
      }
      this.#element.classList.add("redrawn");
      this.#say("Computed by your run.");
    } catch (error) {
      this.#spec = undefined; // there may be a network the next time
      if (run !== this.#run) return;
      this.reset();
      this.#say(`Still of the lesson’s run: ${(error as Error).message}.`);
    }
  }

  /** Shows what the lesson's own run reported. */
  reset(): void {
    ++this.#run;
    for (const [drawing, recorded] of this.#recorded) {
      const whole = new DOMParser().parseFromString(recorded, "text/html").querySelector("svg")!;
      for (const { name, value } of whole.attributes) drawing.setAttribute(name, value);
      drawing.replaceChildren(...whole.childNodes);
    }
    this.#element.classList.remove("yours", "redrawn");
    if (this.#source) this.#source.innerHTML = this.#recordedSource;
  }

  #say(text: string): void {
    this.#element.classList.add("yours");
    if (this.#source) this.#source.textContent = text;
  }
}

async function fetchText(address: string): Promise<string> {
  const response = await fetch(address);
  if (!response.ok) throw new Error("what draws it could not be loaded");
  return response.text();
}

/** The size may differ: a plot is as high as its labels need. */
function redraw(drawing: SVGElement, { svg, width, height }: Drawing): void {
  drawing.innerHTML = svg;
  drawing.setAttribute("viewBox", `0 0 ${width} ${height}`);
  drawing.setAttribute("width", String(width));
  drawing.setAttribute("height", String(height));
}
