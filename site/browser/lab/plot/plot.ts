/**
 * A plot of a lab: uPlot draws the curves, in the page's colours; legend and words are the page's own.
 * Each trace has a dash pattern as well as a colour; those of a ghost are thin and finely dashed.
 */
import uPlot from "uplot";

import type { Plot as PlotDescription } from "../lab-module.js";
import { make } from "../markup/element.js";
import type { Samples } from "../run/samples.js";
import { Legend } from "./legend.js";
import { Palette } from "./palette.js";
import { PlotTable } from "./plot-table.js";
import { dashes, ghostDash } from "./dashes.js";

const height = 156;

export class Plot {
  readonly element: HTMLElement;
  readonly #description: PlotDescription;
  readonly #legend: Legend;
  readonly #table: PlotTable;
  readonly #palette: Palette;
  readonly #uplot: uPlot;
  #shown: [number, number] = [0, 1];

  constructor(description: PlotDescription, samples: Samples) {
    this.#description = description;
    const traces = description.traces.length;
    this.#legend = new Legend(samples.labels, traces);
    this.#table = new PlotTable(description.ylabel);
    const drawing = make("div", { "aria-hidden": "true" });
    const caption = make("figcaption", {}, description.ylabel);
    const parts = [caption, this.#legend.element, drawing, this.#table.element];
    this.element = make("figure", { class: "lab-plot" }, ...parts);
    const { lines } = this.#legend;
    this.#palette = new Palette(this.element, lines, () => this.#uplot.redraw(false, true));
    this.#uplot = new uPlot(this.#options(samples.labels.length), undefined, drawing);
    this.#fit(drawing);
  }

  /** `end` is the time at which the run is. */
  show(samples: Samples, end: number): void {
    const { times, traces } = samples.curves(end);
    this.#shown = [Math.max(0, end - this.#description.window), end];
    if (end < this.#description.window) this.#shown = [0, this.#description.window];
    this.#uplot.setData([times as number[], ...(traces as (number | null | undefined)[][])]);
    this.#legend.show(traces.map((trace) => trace.findLast((value) => value !== undefined)));
  }

  /** In words: while the run is at rest, since words that change thirty times a second are no help. */
  tell(samples: Samples, end: number): void {
    this.#table.show(samples.summary(end));
  }

  #fit(drawing: Element): void {
    new ResizeObserver(([entry]) => {
      const { width } = entry!.contentRect;
      if (width > 0) this.#uplot.setSize({ width, height });
    }).observe(drawing);
  }

  #options(curves: number): uPlot.Options {
    const traces = this.#description.traces.length;
    const series = Array.from({ length: curves }, (_, i): uPlot.Series => {
      const ghost = i >= traces;
      return {
        stroke: () => this.#palette.colours.curves[i]!,
        width: ghost ? 1.25 : 2,
        dash: ghost ? ghostDash : dashes[i]!,
        points: { show: false },
      };
    });
    return {
      width: 300,
      height,
      legend: { show: false },
      cursor: { show: false },
      padding: [8, 8, 0, 0],
      scales: {
        x: { time: false, auto: false, range: () => this.#shown },
        y: { range: (_, low, high) => this.#range(low, high) },
      },
      axes: [this.#axis({ size: 28, values: (_, splits) => splits.map(seconds) }), this.#axis({})],
      series: [{}, ...series],
    };
  }

  #axis(own: uPlot.Axis): uPlot.Axis {
    return {
      stroke: () => this.#palette.colours.text,
      font: `12px ${getComputedStyle(document.documentElement).getPropertyValue("--sans")}`,
      grid: { stroke: () => this.#palette.colours.line, width: 1 },
      ticks: { show: false },
      size: 46,
      values: (_, splits) => splits.map(plain),
      gap: 4,
      ...own,
    };
  }

  /** The author's limits; where there are none, what holds all curves with room to see them. */
  #range(low: number | null, high: number | null): [number, number] {
    const { ymin, ymax } = this.#description;
    const least = low ?? 0;
    const greatest = high ?? 1;
    const flat = greatest - least < 1e-9 * Math.max(1, Math.abs(greatest));
    const room = flat ? Math.max(0.1 * Math.abs(greatest), 0.01) : 0.08 * (greatest - least);
    return [ymin ?? least - room, ymax ?? greatest + room];
  }
}

/** Without the dust of binary fractions, and zero without a sign. */
function plain(value: number): string {
  return String(Number(value.toPrecision(6)) + 0);
}

function seconds(value: number): string {
  return `${plain(value)} s`;
}
