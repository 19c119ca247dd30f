/** What an expression gave, as the type that its place in a lesson needs. */
import { cureOfNumber, Fault, show } from "./fault.js";
import { viewOf } from "./strict-array.js";

/** A finite number; an array of one number counts as that number. */
export function asNumber(value: unknown): number {
  const view = viewOf(value);
  const number = view?.length === 1 ? view[0] : value;
  if (typeof number !== "number") throw wrong(value, "a number");
  if (!Number.isFinite(number)) throw wrong(number, "a finite number");
  return number;
}

export function asTruth(value: unknown): boolean {
  if (typeof value !== "boolean") throw wrong(value, "true or false");
  return value;
}

/** A finite number, a boolean, a string or an array of these, as JSON. */
export function asJson(value: unknown): string {
  return JSON.stringify(plain(value));
}

function plain(value: unknown): unknown {
  const view = viewOf(value) ?? (Array.isArray(value) ? (value as unknown[]) : undefined);
  if (view !== undefined) return Array.from(view, plain);
  if (typeof value === "string" || typeof value === "boolean") return value;
  if (typeof value !== "number") throw wrong(value, "a number, a text or an array of these");
  return asNumber(value);
}

function wrong(value: unknown, wanted: string): Fault {
  const message = `the value is ${show(value)}, not ${wanted}`;
  return new Fault("E-script-value", message, [], cureOfNumber(value));
}
