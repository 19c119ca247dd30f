/** One drawing of a spec: what Vega makes of it, and what is wrong with that. */
import { compile, type TopLevelSpec } from "vega-lite";
import { parse, randomLCG, resetSVGDefIds, setRandom, textMetrics, View, type Spec } from "vega";
import { expressionInterpreter } from "vega-interpreter";

import "./bounded-vega.js";
import { listener } from "./complaint.js";
import { beginCounting, endCounting } from "./counting.js";
import { Refused, type Fault } from "./fault.js";
import type { JsonObject } from "./json.js";
import { widthOf } from "./letters.js";
import { look, type Room } from "./look.js";
import { noRows, setsOfOutliers, tooManySeries, unfitNumbers, unfitSvg } from "./trial.js";
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

// What Vega asks of the surroundings, its chance and its days: its types do not name them.
declare module "vega" {
  interface SetText {
    readonly fontSize?: number;
    readonly fontWeight?: string | number;
  }
  const textMetrics: { width: (item: SetText, text: string | null) => number };
  const randomLCG: (seed: number) => () => number;
  const setRandom: (random: () => number) => void;
  const timeInterval: (
    unit: string,
  ) => { readonly offset: (date: Date, units: number) => Date } | undefined;
}
textMetrics.width = ({ fontSize = 11, fontWeight }, text) =>
  widthOf(text ?? "", fontSize, fontWeight === "bold" || Number(fontWeight) >= 600);

/** Chance is the same in each drawing, whatever was drawn before. */
const seed = 1;

/**
 * Does Vega complain of what no author said? No plot has tooltips but those that Vega-Lite gives to
 * error bars and bands. What is fitted here is not fitted where the author has a step for each value.
 * A boxplot without outliers has no extent of them.
 */
function isOurs(message: string, spec: JsonObject, compiled: Spec): boolean {
  if (message.startsWith("Channel tooltip ")) return true;
  if (message.startsWith('Dropping "fit')) return spec["autosize"] === undefined;
  return message.startsWith("Infinite extent for ") && setsOfOutliers(compiled).size > 0;
}

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
  const compiled = compile(whole as unknown as TopLevelSpec, { config, logger }).spec;
  resetSVGDefIds();
  setRandom(randomLCG(seed));
  beginCounting(spec);
  const runtime = parse(compiled, undefined, { ast: true });
  const view = new View(runtime, { renderer: "none", logger, expr: expressionInterpreter });
  try {
    await view.runAsync();
    endCounting();
    const drawing = finish(await view.toSVG(), id);
    // the causes of whatever else there is to complain of
    const causes = [...noRows(view, compiled), ...unfitNumbers(view, spec)];
    const doubts = complaints.filter(({ message }) => !isOurs(message, spec, compiled));
    const others = [...doubts, ...tooManySeries(view), ...unfitSvg(drawing.svg)];
    faults.push(...(causes.length > 0 ? causes : others));
    return drawing;
  } catch (error) {
    // what Vega cannot run, it only tells its logger, and then it cannot draw it either
    const told = complaints.at(-1);
    throw error instanceof Refused || told === undefined ? error : new Refused(told);
  } finally {
    view.finalize();
  }
}
