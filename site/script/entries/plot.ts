/**
 * Vega-Lite: `draw(spec, table, id)` begins to draw a plot, and `drawn()` gives `{wide, narrow}`, or
 * `{faults}`. Vega answers by promises, which are kept when a call from outside returns: hence two
 * calls.
 */
import "../plot/surroundings.js";

import type { Row } from "../plot/drawing.js";
import { findExcess } from "../plot/bounds.js";
import { vegaFault } from "../plot/complaint.js";
import { fault, Refused, type Fault } from "../plot/fault.js";
import { findUnknownColumns } from "../plot/columns.js";
import { drawForPage, type Drawings } from "../plot/frames.js";
import type { JsonObject } from "../plot/json.js";
import { besideSpec, findUnknown } from "../plot/vocabulary.js";

type Answer = Partial<Drawings> & { readonly faults?: readonly Fault[] };
let answer: Answer | undefined;

/** `json` is the plot as its author wrote it; `table` is "" where it is not known, so that the words
 * alone can be looked at, or the JSON of a list of pairs: a column's name and its numbers. */
function draw(json: string, table: string, id: string): string {
  answer = undefined;
  const spec = specOf(json);
  const columns = table === "" ? [] : (JSON.parse(table) as [string, number[]][]);
  const names = columns.map(([name]) => name);
  const ofTable = table === "" ? [] : findUnknownColumns(spec, names);
  const faults = [...findUnknown(spec), ...findExcess(spec), ...ofTable];
  if (table === "" || faults.length > 0) answer = { faults };
  else void drawKnown(spec, rowsOf(columns), id).then((found) => (answer = found));
  return "";
}

/** Without what stands beside the spec, which was read before. */
function specOf(json: string): JsonObject {
  const members = Object.entries(JSON.parse(json) as JsonObject);
  return Object.fromEntries(members.filter(([key]) => !besideSpec.includes(key)));
}

async function drawKnown(spec: JsonObject, rows: readonly Row[], id: string): Promise<Answer> {
  const faults: Fault[] = [];
  try {
    const drawings = await drawForPage(spec, rows, id, faults);
    return faults.length > 0 ? { faults } : drawings;
  } catch (error) {
    const found =
      error instanceof Refused ? error.fault : vegaFault((error as Error).message, spec);
    return { faults: [...faults, found] };
  }
}

function rowsOf(columns: readonly (readonly [string, readonly number[]])[]): Row[] {
  const [, first] = columns[0]!;
  return first.map((_, i) =>
    Object.fromEntries(columns.map(([name, values]) => [name, values[i]!])),
  );
}

function drawn(): string {
  const never = fault("E-plot-spec", [], "this plot is never done");
  return JSON.stringify(answer ?? { faults: [never] });
}

Object.assign(globalThis, { draw, drawn });
