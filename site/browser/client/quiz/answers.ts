// The answers that a reader gave, kept in the browser from one visit to the next, each with the day
// on which its question comes again.

import { hasAll, isRecord } from "../fields.js";
import { keys, recallJson, remember } from "../storage.js";
import { isReview, type Review } from "./schedule.js";

export interface Answer {
  /** A number as it was typed, or letters: the chosen options, an order's items from the top. */
  readonly given: readonly string[];
  /** Whether any answer was wrong: then the hint was earned. */
  readonly missed: boolean;
  /** Whether the right answer is unfolded, found or given up. */
  readonly shown: boolean;
  /** Once it was answered, in its lesson or in the review. */
  readonly review?: Review;
}

export const noAnswer: Answer = { given: [], missed: false, shown: false };

export function isAnswer(value: unknown): value is Answer {
  return (
    isRecord(value) &&
    hasAll(value, "boolean", ["missed", "shown"]) &&
    Array.isArray(value["given"]) &&
    value["given"].every((part) => typeof part === "string") &&
    (value["review"] === undefined || isReview(value["review"]))
  );
}

/** What the reader last did with that question of the lesson at `path`. */
export function recallAnswer(question: string, path = location.pathname): Answer {
  return recallJson(keys.answer(path, question), isAnswer) ?? noAnswer;
}

/** To remember that nothing was done is to forget. */
export function rememberAnswer(question: string, answer: Answer, path = location.pathname): void {
  const { given, missed, shown, review } = answer;
  const untouched = given.length === 0 && !missed && !shown && !review;
  remember(keys.answer(path, question), untouched ? null : JSON.stringify(answer));
}
