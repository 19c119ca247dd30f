/** Does the table have the columns that a spec and its expressions speak of? Vega draws nothing for those that it has
 * not. What a transform makes is a column as well. */
import { parseExpression } from "vega";

import { bytes } from "../bytes.js";
import { suggest } from "../suggest.js";
import { fault, type Fault, type Path } from "./fault.js";
import { isObject, stringsOf, walk, type Json, type JsonObject } from "./json.js";

/** Keys whose strings name columns, besides `field`. */
const lists = new Set(["groupby", "fold", "flatten", "lookup", "argmax", "argmin"]);
/** Keys of a transform that do so. */
const ofTransforms = new Set(
  ["density", "extent", "impute", "key", "loess", "on", "quantile", "regression", "stack"], // prettier-ignore
);
export const expressionKeys = new Set(["calculate", "filter", "expr", "test", "labelExpr"]);

/** What of an axis, a legend or a header is asked for a value is asked with a datum of its own. */
const guides = new Set(["axis", "header", "legend"]);
const ofGuides = ["value", "label", "index"];

/** These count rows, and read no column, whatever `field` says. */
const counting = new Set(
  ["count", "row_number", "rank", "dense_rank", "percent_rank", "cume_dist", "ntile"], // prettier-ignore
);

class Columns {
  readonly #table: readonly string[];
  readonly #made = new Set<string>();
  /** Of those that were made, the ones that hold whole rows. */
  readonly #rows = new Set<string>();
  /** A pivot makes columns of values, which nobody knows before. */
  #open = false;

  constructor(spec: Json, table: readonly string[]) {
    this.#table = table;
    walk(spec, (value, _, key) => {
      if (key === "transform" && isObject(value)) this.#addMade(value);
    });
  }

  #addMade(transform: JsonObject): void {
    if (transform["pivot"] !== undefined) this.#open = true;
    const named: string[] = [];
    walk(transform, (value, path, key) => {
      if (key === "as") named.push(...stringsOf(value));
    });
    if (transform["fold"] !== undefined) named.push("key", "value");
    if (transform["density"] !== undefined) named.push("value", "density");
    if (transform["quantile"] !== undefined) named.push("prob", "value");
    if (transform["params"] === true) named.push("coef", "rSquared", "keys");
    for (const name of named) this.#made.add(name);
    if (["bin", "stack", "timeUnit"].some((key) => transform[key] !== undefined)) {
      for (const name of named) this.#made.add(`${name}_end`);
    }
    walk(transform, (value) => {
      if (!isObject(value) || (value["op"] !== "argmax" && value["op"] !== "argmin")) return;
      for (const name of stringsOf(value["as"])) this.#rows.add(name);
    });
  }

  faults(spec: Json): Fault[] {
    if (this.#open) return [];
    const faults: Fault[] = [];
    walk(spec, (value, path, key, around) => {
      if (typeof value !== "string") return;
      if (namesColumn(path, key, around)) this.#check(value, [0, value.length], path, faults);
      if (expressionKeys.has(key)) this.#checkExpression(value, path, faults);
    });
    return faults;
  }

  /** Is it one, and of columns that there are: `datum.time`, `datum['time']`? */
  #checkExpression(text: string, path: Path, faults: Fault[]): void {
    try {
      parseExpression(text);
    } catch (error) {
      const message = `this is no expression: ${(error as Error).message}`;
      faults.push(fault("E-plot-spec", path, message));
    }
    for (const match of text.matchAll(/\bdatum(?:\.([\w$]+)|\[\s*(["'])(.*?)\2\s*\])/dg)) {
      this.#check(text, match.indices![match[1] === undefined ? 3 : 1]!, path, faults);
    }
  }

  /** The column that is named from `from` to `to` of `text`, which stands at `path`. */
  #check(text: string, [from, to]: readonly [number, number], path: Path, faults: Fault[]): void {
    const name = text.slice(from, to).replace(/\\(.)/g, "$1");
    const guide = path.find((step) => guides.has(String(step)));
    const known = guide === undefined ? [...this.#table, ...this.#made] : ofGuides;
    if (known.includes(name) || (guide === undefined && this.#isOfRow(name))) return;
    const message =
      guide === undefined
        ? `the table has no column "${name}", and no transform makes it`
        : `${guide === "axis" ? "an" : "a"} ${guide} knows its own values, and no column "${name}"`;
    const cure = suggest(name, known);
    const part = { from: bytes(text.slice(0, from)), to: bytes(text.slice(0, to)) };
    faults.push({ ...fault("E-plot-field", path, message, cure), ...part });
  }

  /** `best.time` or `best['time']`, where `best` is a row of the table. */
  #isOfRow(name: string): boolean {
    const [, row, member, , quoted] =
      /^([^.[\]]+)(?:\.([^.[\]]+)|\[(["']?)(.*)\3\])$/.exec(name) ?? [];
    const column = member ?? quoted;
    if (column === undefined || !this.#rows.has(row!)) return false;
    return this.#table.includes(column) || this.#made.has(column);
  }
}

/** Does the string at `path`, which stands in `around`, name a column? */
function namesColumn(path: Path, key: string, around: Json): boolean {
  if (key === "field") return !(isObject(around) && countsRows(around));
  // {"repeat": "row"} is what the spec repeats: ["speed"], or {"row": ["speed"]}
  const repeated = typeof path.at(-1) === "number" && path.slice(-3).includes("repeat");
  const ofTransform = path.at(-3) === "transform" && ofTransforms.has(key);
  return lists.has(key) || repeated || ofTransform;
}

function countsRows({ op, aggregate }: JsonObject): boolean {
  return aggregate === "count" || (typeof op === "string" && counting.has(op));
}

export function findUnknownColumns(spec: Json, table: readonly string[]): Fault[] {
  return new Columns(spec, table).faults(spec);
}
