// How far each lesson was read.

import { hasAll, isRecord } from "../fields.js";
import { keys, recallJson, remember } from "../storage.js";

export interface Reading {
  /** "1.2 Generalized coordinates" */
  readonly name: string;
  /** How many of its headings were reached. */
  readonly place: number;
  /** The id of the last of them, and its text; both "" for none. */
  readonly section: string;
  readonly heading: string;
  /** Whether its end was reached. */
  readonly ended: boolean;
  readonly done: boolean;
}

/** What a lesson is to its reader, from least to most. */
export type State = "new" | "started" | "ended" | "done";

export const words: Readonly<Record<State, string>> = {
  new: "not opened",
  started: "started",
  ended: "read to the end",
  done: "done",
};

export function stateOf(reading: Reading | undefined): State {
  if (!reading) return "new";
  if (reading.done) return "done";
  return reading.ended ? "ended" : "started";
}

export function isReading(value: unknown): value is Reading {
  return (
    isRecord(value) &&
    hasAll(value, "string", ["name", "section", "heading"]) &&
    hasAll(value, "number", ["place"]) &&
    hasAll(value, "boolean", ["ended", "done"])
  );
}

/** Of the lesson whose address has this path; undefined where it was never opened. */
export const recallReading = (path: string): Reading | undefined =>
  recallJson(keys.reading(path), isReading);

export function rememberReading(path: string, reading: Reading | null): void {
  remember(keys.reading(path), reading && JSON.stringify(reading));
}
