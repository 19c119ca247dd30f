/**
 * A mistake of the author's in a script, with what is needed to point at it. The ids are explained in
 * generator/script/script_error.h.
 */
export type FaultId = "E-script-foreign" | "E-script-name" | "E-script-range" | "E-script-value";

export class Fault extends Error {
  constructor(
    readonly id: FaultId,
    message: string,
    /** Texts to underline, best first: the first that stands in the author's line is taken. */
    readonly tokens: readonly string[],
    /** What to do about it; "" when there is nothing to suggest. */
    readonly cure = "",
  ) {
    super(message);
  }
}

/** What to do about a number that is not finite; "" for any other value. */
export function cureOfNumber(value: unknown): string {
  if (typeof value !== "number" || Number.isFinite(value)) return "";
  return "look for a division by 0, or a root or a logarithm of a negative number";
}

/** A value in a message. */
export function show(value: unknown): string {
  if (typeof value === "string") return JSON.stringify(value);
  if (typeof value === "function") return "a function";
  if (typeof value === "object" && value !== null && "length" in value) {
    return `an array of length ${String(value.length)}`;
  }
  if (typeof value === "object" && value !== null) return "an object";
  return String(value);
}
