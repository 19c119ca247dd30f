// When a question comes again: Leitner's boxes. A right answer moves it to the next box, a wrong one
// back to the first; the further the box, the longer it waits.
//
// Days are those of the reader's own calendar, written "2026-11-22", so that they compare as text.

import { hasAll, isRecord } from "../fields.js";

export interface Review {
  /** From 1. */
  readonly box: number;
  /** The first day on which it comes again. */
  readonly due: string;
}

/** How many days a question waits in each box. */
const waits = [1, 3, 7, 21] as const;

export function isReview(value: unknown): value is Review {
  return (
    isRecord(value) &&
    hasAll(value, "number", ["box"]) &&
    waits.some((_, index) => value["box"] === index + 1) &&
    hasAll(value, "string", ["due"]) &&
    /^\d{4}-\d\d-\d\d$/.test(String(value["due"])) &&
    !Number.isNaN(Date.parse(String(value["due"])))
  );
}

/** The day that lies so many days after today. */
export function dayIn(days: number): string {
  const day = new Date();
  day.setDate(day.getDate() + days);
  const parts = [day.getFullYear(), day.getMonth() + 1, day.getDate()];
  return parts.map((part) => String(part).padStart(2, "0")).join("-");
}

/** What was never answered is due as well. */
export const isDue = (review: Review | undefined): boolean => !review || review.due <= dayIn(0);

/** After an answer. One that is right before its day, as when trying again, changes nothing. */
export function reviewed(before: Review | undefined, right: boolean): Review {
  if (right && before && !isDue(before)) return before;
  const box = right ? Math.min((before?.box ?? 0) + 1, waits.length) : 1;
  return { box, due: dayIn(waits[box - 1]!) };
}
