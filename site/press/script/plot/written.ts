/** A plot as its author wrote it and the table that it shows, in the forms that Vega-Lite takes. */
import type { Row } from "./drawing.js";
import type { JsonObject } from "./json.js";
import { besideSpec } from "./vocabulary.js";

/** A column's name and its numbers; all columns of a table are as long. */
export type Columns = readonly (readonly [name: string, numbers: readonly number[]])[];

/** The spec in a plot's JSON, without what stands beside it. */
export function specOf(json: string): JsonObject {
  const members = Object.entries(JSON.parse(json) as JsonObject);
  return Object.fromEntries(members.filter(([key]) => !besideSpec.includes(key)));
}

/** `columns` has one column at least. */
export function rowsOf(columns: Columns): Row[] {
  const [, first] = columns[0]!;
  return first.map((_, i) =>
    Object.fromEntries(columns.map(([name, values]) => [name, values[i]!])),
  );
}
