/**
 * Vega-Lite: `draw(spec, table, id)` begins to draw a plot, and `drawn()` gives `{wide, narrow}`, or
 * `{faults}`. Vega answers by promises, which are kept when a call from outside returns: hence two
 * calls.
 */
import "../plot/surroundings.js";

import type { Row } from "../plot/drawing.js";
import { findExcess } from "../plot/bounds.js";
import { faultOf, unexplained } from "../plot/complaint.js";
import { findCulprit } from "../plot/culprit.js";
import { fault, Refused, type Fault } from "../plot/fault.js";
import { findUnfitDomains } from "../plot/domains.js";
import { findUnknownColumns } from "../plot/columns.js";
import { drawForPage, type Drawings } from "../plot/frames.js";
import type { JsonObject } from "../plot/json.js";
import { rowsOf, specOf, type Columns } from "../plot/written.js";
import { findUnknown } from "../plot/vocabulary.js";

type Answer = Partial<Drawings> & { readonly faults?: readonly Fault[] };
let answer: Answer | undefined;

/**
 * `json` is the plot as its author wrote it. `table` is "" where it is not known, so that the words
 * alone can be looked at. Else it is the JSON of a list of pairs: a column's name and its numbers.
 */
function draw(json: string, table: string, id: string): string {
  answer = undefined;
  const spec = specOf(json);
  const columns = table === "" ? [] : (JSON.parse(table) as Columns);
  const names = columns.map(([name]) => name);
  const ofTable = table === "" ? [] : findUnknownColumns(spec, names);
  const faults = [...findUnknown(spec), ...findExcess(spec), ...findUnfitDomains(spec), ...ofTable];
  if (table === "" || faults.length > 0) answer = { faults };
  else void drawKnown(spec, rowsOf(columns), id).then((found) => (answer = found));
  return "";
}

async function drawKnown(spec: JsonObject, rows: readonly Row[], id: string): Promise<Answer> {
  const faults: Fault[] = [];
  try {
    const drawings = await drawForPage(spec, rows, id, faults);
    if (faults.length === 0) return drawings;
  } catch (error) {
    faults.push(error instanceof Refused ? error.fault : faultOf(error as Error, spec));
  }
  const unclear = faults.indexOf(unexplained);
  if (unclear >= 0) faults[unclear] = await explain(spec, rows);
  return { faults };
}

/** So many rows fail like all, most often, and are soon drawn. */
const fewRows = 20;

async function explain(spec: JsonObject, rows: readonly Row[]): Promise<Fault> {
  const fails = (part: JsonObject) => failsToDraw(part, rows.slice(0, fewRows));
  const path = (await fails(spec)) ? await findCulprit(spec, fails) : [];
  const key = path.filter((step) => typeof step === "string").at(-1);
  if (key === undefined) return unexplained;
  const message = `Vega-Lite cannot draw a plot with this "${key}", and does not say why`;
  const cure = `see what its documentation says of "${key}", or leave it out`;
  return { ...fault("E-plot-spec", path, message, cure), key: path.at(-1) === key };
}

async function failsToDraw(spec: JsonObject, rows: readonly Row[]): Promise<boolean> {
  const faults: Fault[] = [];
  try {
    await drawForPage(spec, rows, "trial", faults);
    return faults.includes(unexplained);
  } catch {
    return true;
  }
}

function drawn(): string {
  const never = fault("E-plot-spec", [], "this plot is never done");
  return JSON.stringify(answer ?? { faults: [never] });
}

Object.assign(globalThis, { draw, drawn });
