/** Does the table have the columns that a spec and its expressions speak of? Vega draws nothing for those that it has
 * not. What a transform makes is a column as well. */
import { parseExpression } from "vega";

import { bytes } from "../bytes.js";
import { suggest } from "../suggest.js";
import { fault, type Fault, type Path } from "./fault.js";
import { isObject, stringsOf, walk, type Json, type JsonObject } from "./json.js";

/** Keys whose strings name columns, besides `field`. */
const lists = new Set(["groupby", "fold", "flatten", "repeat", "lookup"]);
export const expressionKeys = new Set(["calculate", "filter", "expr", "test"]);

class Columns {
  readonly #table: readonly string[];
  readonly #made = new Set<string>();
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
    for (const name of named) this.#made.add(name);
    if (transform["bin"] !== undefined) {
      for (const name of named) this.#made.add(`${name}_end`);
    }
  }

  faults(spec: Json): Fault[] {
    if (this.#open) return [];
    const faults: Fault[] = [];
    walk(spec, (value, path, key) => {
      if (typeof value !== "string") return;
      // {"field": {"repeat": "row"}} is what the spec repeats
      const repeated = key === "repeat" && path.at(-2) === "field";
      const named = (lists.has(key) && !repeated) || path.at(-3) === "repeat";
      if (key === "field" || named) this.#check(value, [0, value.length], path, faults);
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
    if (this.#table.includes(name) || this.#made.has(name)) return;
    const message = `the table has no column "${name}", and no transform makes it`;
    const cure = suggest(name, [...this.#table, ...this.#made]);
    const part = { from: bytes(text.slice(0, from)), to: bytes(text.slice(0, to)) };
    faults.push({ ...fault("E-plot-field", path, message, cure), ...part });
  }
}

export function findUnknownColumns(spec: Json, table: readonly string[]): Fault[] {
  return new Columns(spec, table).faults(spec);
}
