// Of what is here and what comes from a file, the better.

import type { Answer } from "../quiz/answers.js";
import type { Review } from "../quiz/schedule.js";
import type { Reading } from "../reading/readings.js";
import type { Kept, Lesson } from "./lessons.js";

function furthest(own: Reading | undefined, other: Reading | undefined): Reading | undefined {
  if (!own || !other) return own ?? other;
  const { place, section, heading } = other.place > own.place ? other : own;
  const ended = own.ended || other.ended;
  return { ...own, place, section, heading, ended, done: own.done || other.done };
}

/** The further box; of the same, the later day. */
function better(own: Review | undefined, other: Review | undefined): Review | undefined {
  if (!own || !other) return own ?? other;
  if (own.box !== other.box) return own.box > other.box ? own : other;
  return own.due >= other.due ? own : other;
}

/** A right answer before a wrong one, and that before none; of two alike, our own. */
function bestAnswer(own: Answer, other: Answer, isRight: (given: readonly string[]) => boolean) {
  const worth = ({ given }: Answer): number => (isRight(given) ? 2 : Math.min(given.length, 1));
  const best = worth(other) > worth(own) ? other : own;
  const review = better(own.review, other.review);
  return { ...best, shown: own.shown || other.shown, ...(review && { review }) };
}

export function merge(lesson: Lesson, other: Kept): Kept {
  const own = lesson.kept;
  const answers = { ...other.answers, ...own.answers };
  for (const [id, answer] of Object.entries(own.answers)) {
    const theirs = Object.hasOwn(other.answers, id) ? other.answers[id] : undefined;
    if (theirs) answers[id] = bestAnswer(answer, theirs, (given) => lesson.isRight(id, given));
  }
  // Nothing tells which of two texts is the better one.
  const texts = { ...other.texts, ...own.texts };
  return { reading: furthest(own.reading, other.reading), answers, texts };
}
