// The answers that a reader gave, kept in the browser from one visit to the next.
//
// The key bears a version: when what is kept changes its form, the old is left alone and not misread.

import { recall, remember } from "../storage.js";

const version = 1;

const keyOf = (question: string): string =>
  `mjcourse.answer.v${version}:${location.pathname}#${question}`;

/** What the reader last answered to the question of that id; null when nothing. */
export function recallAnswer(question: string): string | null {
  return recall(keyOf(question));
}

/** Null forgets. */
export function rememberAnswer(question: string, answer: string | null): void {
  remember(keyOf(question), answer);
}
