/** What a plot makes of its table, counted while Vega draws it (bounded-vega.ts), so that it ends where that
 * is too much. */
import { mostBins, mostParts, mostTicks, tooManyParts } from "./bounds.js";
import { fault, Refused, type Path } from "./fault.js";
import { isObject, walk, type JsonObject } from "./json.js";

/** Rows that transforms add to those of the table, and numbers of `sequence`. */
const mostRows = 200_000;

// Vega's transforms and functions are the same for all drawings, of which there is one at a time.
let spec: JsonObject = {};
let rows = 0;
let parts = 0;
let excess: Refused | undefined;

/** To be called before each drawing. */
export function beginCounting(drawn: JsonObject): void {
  spec = drawn;
  rows = 0;
  parts = 0;
  excess = undefined;
}

/** Vega only tells its logger of what its transforms throw. */
export function endCounting(): void {
  if (excess !== undefined) throw excess;
}

export function exceed(path: Path, message: string, cure: string): never {
  excess ??= new Refused(fault("E-plot-size", path, message, cure));
  throw excess;
}

export function addRows(number: number, path: () => Path): void {
  rows += number;
  if (rows <= mostRows) return;
  const message = `with this, the plot makes ${Math.round(rows)} rows of its own, and ${mostRows} are the most`;
  exceed(path(), message, "let it make fewer");
}

/** One more part of the plot, or one more line of it. */
export function addPart(): void {
  parts += 1;
  if (parts <= mostParts) return;
  const place = placeOf(["facet", "row", "column"]);
  exceed(place.length > 0 ? place : placeOf(["detail", "color"]), ...tooManyParts(parts));
}

export interface Bins {
  readonly start: number;
  readonly stop: number;
  readonly step: number;
}

export function checkBins({ start, stop, step }: Bins, path: () => Path): void {
  const count = Math.ceil((stop - start) / step);
  if (!(count >= 0)) {
    exceed(path(), "no bins are as these should be", 'write `"extent": [0, 5], "step": 0.5`');
  }
  if (count <= mostBins) return;
  exceed(path(), `this makes ${count} bins, and ${mostBins} are the most`, "make them wider");
}

export function checkTicks(count: number): void {
  if (count <= mostTicks) return;
  const message = `this makes ${Math.round(count)} ticks, and ${mostTicks} are the most`;
  exceed(placeOf(["tickCount"]), message, "let them be fewer");
}

/** Where the spec has one of `keys` for the column `name`; else, where it has one first. */
export function placeOf(keys: readonly string[], name?: string | null): Path {
  let first: Path | undefined;
  let meant: Path | undefined;
  walk(spec, (value, path, key, around) => {
    if (!keys.includes(key) || path.at(-1) !== key) return;
    const own = isObject(value) ? value["field"] : value;
    const outer = isObject(around) ? around["field"] : undefined;
    first ??= path;
    if (own === name || outer === name) meant ??= path;
  });
  return meant ?? first ?? [];
}

/** Where the spec calls `name`, as Vega-Lite does for the key values of an imputation. */
export function placeOfCall(name: string): Path {
  let found: Path | undefined;
  walk(spec, (value, path, key) => {
    const calls = typeof value === "string" && value.includes(`${name}(`);
    if (calls || (name === "sequence" && key === "keyvals")) found ??= path;
  });
  return found ?? [];
}
