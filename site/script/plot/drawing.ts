/** One drawing of a spec: what Vega makes of it, and what is wrong with that. */
import { compile, type TopLevelSpec } from "vega-lite";
import { parse, resetSVGDefIds, textMetrics, View } from "vega";

import type { Fault } from "./fault.js";
import { listener } from "./complaint.js";
import type { JsonObject } from "./json.js";
import { widthOf } from "./letters.js";
import { look, type Room } from "./look.js";
import { noRows, tooManySeries, unfitNumbers, unfitSvg } from "./trial.js";
import { finish } from "./svg.js";
import { refine } from "./refine.js";

export type Row = Readonly<Record<string, number>>;

export interface Setting {
  /** Begins the ids of the drawing, which share the page with those of others. */
  readonly id: string;
  /** How much has room beside each other. */
  readonly room: Room;
}

export interface Drawing {
  readonly svg: string;
  readonly width: number;
  readonly height: number;
}

// The one thing that Vega asks of the surroundings which its types do not name.
declare module "vega" {
  interface SetText {
    readonly fontSize?: number;
    readonly fontWeight?: string | number;
  }
  const textMetrics: { width: (item: SetText, text: string | null) => number };
}
textMetrics.width = ({ fontSize = 11, fontWeight }, text) =>
  widthOf(text ?? "", fontSize, fontWeight === "bold" || Number(fontWeight) >= 600);

/** Draws `sized`, which is the author's `spec` with a size. Rejects with Vega's own exception; what it
 * only complains of is added to `faults`. */
export async function draw(
  spec: JsonObject,
  sized: JsonObject,
  rows: readonly Row[],
  { id, room }: Setting,
  faults: Fault[],
): Promise<Drawing> {
  const complaints: Fault[] = [];
  const logger = listener(spec, complaints);
  const whole = {
    ...refine(sized),
    data: { name: "table" },
    datasets: { table: rows.map((row) => ({ ...row })) },
  };
  const config = look(room);
  const compiled = compile(whole as unknown as TopLevelSpec, { config, logger });
  resetSVGDefIds();
  const view = new View(parse(compiled.spec), { renderer: "none", logger });
  try {
    await view.runAsync();
    const drawing = finish(await view.toSVG(), id);
    // the causes of whatever else there is to complain of
    const causes = [...noRows(view), ...unfitNumbers(view, spec)];
    const others = [...complaints, ...tooManySeries(view), ...unfitSvg(drawing.svg)];
    faults.push(...(causes.length > 0 ? causes : others));
    return drawing;
  } finally {
    view.finalize();
  }
}
