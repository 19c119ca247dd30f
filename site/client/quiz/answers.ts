// The answers that a reader gave, kept in the browser from one visit to the next.
//
// The key bears a version: when what is kept changes its form, the old is left alone and not misread.

import { recall, remember } from "../storage.js";

export interface Answer {
  /** A number as it was typed, or letters: the chosen options, an order's items from the top. */
  readonly given: readonly string[];
  /** Whether any answer was wrong: then the hint was earned. */
  readonly missed: boolean;
  /** Whether the right answer is unfolded, found or given up. */
  readonly shown: boolean;
}

export const noAnswer: Answer = { given: [], missed: false, shown: false };

const version = 2;

const keyOf = (question: string): string =>
  `mjcourse.answer.v${version}:${location.pathname}#${question}`;

function isAnswer(value: unknown): value is Answer {
  return (
    typeof value === "object" &&
    value !== null &&
    "given" in value &&
    Array.isArray(value.given) &&
    value.given.every((part) => typeof part === "string") &&
    "missed" in value &&
    typeof value.missed === "boolean" &&
    "shown" in value &&
    typeof value.shown === "boolean"
  );
}

/** What the reader last did with the question of that id. */
export function recallAnswer(question: string): Answer {
  try {
    const kept: unknown = JSON.parse(recall(keyOf(question)) ?? "null");
    return isAnswer(kept) ? kept : noAnswer;
  } catch {
    return noAnswer; // not ours
  }
}

/** To remember that nothing was done is to forget. */
export function rememberAnswer(question: string, answer: Answer): void {
  const untouched = answer.given.length === 0 && !answer.missed && !answer.shown;
  remember(keyOf(question), untouched ? null : JSON.stringify(answer));
}
