/** How plots look: quiet axes, the site's sans, and its colours by their names, which live on in the
 * SVG, so that one drawing serves light and dark. */
import type { Config } from "vega-lite";

const size = 13;
const sans = "var(--sans)";

/** As many series as there are colours. The dashes are those of the labs' plots. */
export const colours = ["var(--data-1)", "var(--data-2)", "var(--data-3)", "var(--data-4)"];
export const dashes = [[1, 0], [9, 4], [2, 3], [9, 3, 2, 3]]; // prettier-ignore
export const shapes = ["circle", "square", "triangle-up", "diamond"];

/** How many entries of a legend, and labels of an axis, there should be side by side. */
export interface Room {
  readonly legend: number;
  readonly ticks: number;
}

export function look(room: Room): Config {
  return {
    font: sans,
    background: "transparent",
    padding: 4,
    aria: false,
    view: { stroke: null },
    // a number that is none is to be seen and refused, not left out
    mark: { color: colours[0]!, invalid: "show" },
    line: { strokeWidth: 2, strokeCap: "butt", strokeJoin: "round" },
    trail: { color: colours[0]! },
    point: { filled: true, size: 40, opacity: 1 },
    circle: { size: 40, opacity: 1 },
    square: { size: 40, opacity: 1 },
    area: { fillOpacity: 0.25 },
    rule: { color: "var(--edge)" },
    tick: { color: colours[0]! },
    text: { color: "var(--ink)", fontSize: size },
    range: {
      category: colours,
      ordinal: colours,
      symbol: shapes,
      // the part of viridis that stands out from both grounds
      ramp: { scheme: "viridis", extent: [0.25, 0.8] },
      heatmap: { scheme: "viridis", extent: [0.25, 0.8] },
    },
    axis: {
      domainColor: "var(--edge)",
      gridColor: "var(--line)",
      tickColor: "var(--edge)",
      tickSize: 4,
      labelColor: "var(--soft)",
      labelFontSize: size,
      labelPadding: 4,
      titleColor: "var(--ink)",
      titleFontSize: size,
      titleFontWeight: 400,
      titlePadding: 8,
    },
    axisX: { grid: false },
    axisY: { domain: false, ticks: false, grid: true },
    axisXQuantitative: { tickCount: room.ticks },
    axisYQuantitative: { tickCount: 5 },
    legend: {
      orient: "top",
      direction: "horizontal",
      columns: room.legend,
      columnPadding: 20,
      labelColor: "var(--ink)",
      labelFontSize: size,
      labelLimit: 0,
      titleColor: "var(--soft)",
      titleFontSize: size,
      titleFontWeight: 400,
      symbolSize: 120,
      symbolStrokeWidth: 2,
    },
    header: { labelFontSize: size, labelColor: "var(--ink)", titleFontSize: size },
    title: { anchor: "start", color: "var(--ink)", fontSize: size + 2, fontWeight: 600 },
  };
}
