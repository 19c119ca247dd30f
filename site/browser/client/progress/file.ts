// The file that a reader's progress is exported to and imported from. It comes from anywhere, so it is
// looked at as a whole before anything of it is taken.

import { isRecord } from "../fields.js";
import { isAnswer } from "../quiz/answers.js";
import { isReading } from "../reading/readings.js";
import type { Kept } from "./lessons.js";

const format = "mjcourse progress";
/** Bytes: many times what a course of thousands of lessons has. */
export const mostBytes = 16 << 20;
const version = 1;

export interface Progress {
  /** The page of the lesson that was read last, below the site's root; "" for none. */
  readonly last: string;
  /** By their pages below the site's root. */
  readonly lessons: Readonly<Record<string, Kept>>;
}

/** A sentence that tells the reader what is wrong with a file. */
export class Unreadable extends Error {}

export const textOf = (progress: Progress, course: string): string =>
  `${JSON.stringify({ format, version, course, ...progress }, null, 1)}\n`;

function parsed(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    throw new Unreadable("it is not JSON");
  }
}

const isTexts = (value: unknown): boolean =>
  isRecord(value) && Object.values(value).every((text) => typeof text === "string");

function isKept(value: unknown): value is Kept {
  return (
    isRecord(value) &&
    (value["reading"] === undefined || isReading(value["reading"])) &&
    isRecord(value["answers"]) &&
    Object.values(value["answers"]).every(isAnswer) &&
    (value["texts"] === undefined || isTexts(value["texts"]))
  );
}

/** Throws Unreadable. */
export function progressOf(text: string): Progress {
  const file = parsed(text);
  if (!isRecord(file) || file["format"] !== format) {
    throw new Unreadable("it was not exported from a page like this one");
  }
  if (file["version"] !== version) {
    throw new Unreadable(`it has another version than ${version}, which this page reads`);
  }
  const { last, lessons } = file;
  if (typeof last !== "string" || !isRecord(lessons))
    throw new Unreadable("a part of it is missing");
  for (const [page, kept] of Object.entries(lessons)) {
    if (!isKept(kept)) throw new Unreadable(`what it says of ${page} cannot be read`);
  }
  return { last, lessons: lessons as Readonly<Record<string, Kept>> };
}
