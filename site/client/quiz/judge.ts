// Right or wrong: what is given held against what the form says is right.

import { parseNumber } from "./number.js";

export type Verdict = "right" | "wrong" | "unclear" | "none";

/**
 * A form's data-kind is its question's; data-key is what is right: the number, or letters with
 * spaces between; data-tolerance is by how much a number may differ.
 */
export function judge(form: HTMLFormElement, given: readonly string[]): Verdict {
  if (given.length === 0) return "none";
  const { kind, key, tolerance } = form.dataset;
  if (kind !== "numeric") return given.join(" ") === key ? "right" : "wrong";
  const value = parseNumber(given[0]!);
  if (value === undefined) return "unclear";
  // Decimals are not exact in binary: a tolerance of 0 still allows for that.
  const right = Number(key);
  const allowed = Number(tolerance) + 1e-12 * Math.max(1, Math.abs(right));
  return Math.abs(value - right) <= allowed ? "right" : "wrong";
}
