// Right or wrong: what is given held against what is right.

import { isNear } from "./near.js";
import { parseNumber } from "./number.js";

export type Verdict = "right" | "wrong" | "unclear" | "none";

/**
 * As a question's form has it in its data: its kind; the key, the number or letters with spaces
 * between; the tolerance, by how much a number may differ.
 */
export interface Solution {
  readonly kind?: string;
  readonly key?: string;
  readonly tolerance?: string;
}

export function judge({ kind, key, tolerance }: Solution, given: readonly string[]): Verdict {
  if (given.length === 0) return "none";
  if (kind !== "numeric") return given.join(" ") === key ? "right" : "wrong";
  const value = parseNumber(given[0]!);
  if (value === undefined) return "unclear";
  return isNear(value, Number(key), Number(tolerance)) ? "right" : "wrong";
}
