// The questions that can come in a review: those of the lessons that were opened, each with its day.

import { recallAnswer, rememberAnswer } from "../quiz/answers.js";
import { isDue, reviewed, type Review } from "../quiz/schedule.js";
import { recallReading } from "../reading/readings.js";

/** As the generator writes it (page/lesson_parts.h). */
interface LessonQuestions {
  /** Its page below the site's root. */
  readonly href: string;
  /** "1.2 Generalized coordinates" */
  readonly name: string;
  readonly questions: readonly { readonly id: string; readonly html: string }[];
}

declare global {
  var mjcourseQuestions: readonly LessonQuestions[] | undefined;
}

export class Card {
  readonly href: string;
  readonly lesson: string;
  readonly id: string;
  readonly html: string;
  readonly #path: string;

  constructor({ href, name }: LessonQuestions, { id, html }: { id: string; html: string }) {
    this.href = `${href}#${id}`;
    this.lesson = name;
    this.id = id;
    this.html = html;
    this.#path = new URL(href, location.href).pathname;
  }

  /** One is solved in its lesson. */
  get isExercise(): boolean {
    return this.id.startsWith("exercise-");
  }

  get review(): Review | undefined {
    return recallAnswer(this.id, this.#path).review;
  }

  get isDue(): boolean {
    return isDue(this.review);
  }

  /** What the lesson shows of the question stays as it was. */
  judged(right: boolean): void {
    const answer = recallAnswer(this.id, this.#path);
    const review = reviewed(answer.review, right);
    rememberAnswer(this.id, { ...answer, review }, this.#path);
  }
}

/** In the order of the course. */
export function openedCards(): Card[] {
  const lessons = globalThis.mjcourseQuestions ?? [];
  return lessons
    .filter(({ href }) => recallReading(new URL(href, location.href).pathname) !== undefined)
    .flatMap((lesson) => lesson.questions.map((question) => new Card(lesson, question)))
    .filter((card) => !card.isExercise || card.review);
}
