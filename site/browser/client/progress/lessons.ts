// The lessons of the course as the table of progress.html lists them, each with what is remembered.

import { isAnswer, noAnswer, recallAnswer, rememberAnswer, type Answer } from "../quiz/answers.js";
import { forgetText, keepText, keptText } from "../program-text.js";
import { judge, type Solution } from "../quiz/judge.js";
import { recallReading, rememberReading, type Reading } from "../reading/readings.js";

/** What is remembered of one lesson: its answers by their questions' ids. */
export interface Kept {
  readonly reading?: Reading | undefined;
  readonly answers: Readonly<Record<string, Answer>>;
  /** What the reader wrote of its exercises, by their programs. */
  readonly texts?: Readonly<Record<string, string>> | undefined;
}

export class Lesson {
  readonly row: HTMLTableRowElement;
  /** Its page below the site's root, the same wherever the site lies. */
  readonly href: string;
  readonly #path: string;
  /** By their ids. */
  readonly #solutions: ReadonlyMap<string, Solution>;
  readonly #programs: readonly string[];

  constructor(row: HTMLTableRowElement) {
    this.row = row;
    this.href = row.dataset["lesson"]!;
    this.#path = new URL(this.href, location.href).pathname;
    const questions = [...row.querySelectorAll<HTMLElement>("[data-id]")];
    this.#solutions = new Map(questions.map(({ dataset }) => [dataset["id"]!, dataset]));
    this.#programs = questions.flatMap(({ dataset }) => dataset["program"] ?? []);
  }

  get path(): string {
    return this.#path;
  }

  get questions(): number {
    return this.#solutions.size;
  }

  /** How many questions were answered rightly. */
  get right(): number {
    return Object.entries(this.kept.answers).filter(([id, { given }]) => this.isRight(id, given))
      .length;
  }

  isRight(question: string, given: readonly string[]): boolean {
    return judge(this.#solutions.get(question) ?? {}, given) === "right";
  }

  get kept(): Kept {
    const answers = [...this.#solutions.keys()].map(
      (id) => [id, recallAnswer(id, this.#path)] as const,
    );
    const texts = this.#programs.flatMap((program) => {
      const text = keptText(program);
      return text === undefined ? [] : [[program, text] as const];
    });
    return {
      reading: recallReading(this.#path),
      answers: Object.fromEntries(answers.filter(([, answer]) => answer !== noAnswer)),
      ...(texts.length > 0 && { texts: Object.fromEntries(texts) }),
    };
  }

  /** In place of what was remembered. Questions that the lesson has not are passed over. */
  keep({ reading, answers, texts = {} }: Kept): void {
    rememberReading(this.#path, reading ?? null);
    for (const id of this.#solutions.keys()) {
      const answer = Object.hasOwn(answers, id) ? answers[id] : noAnswer;
      rememberAnswer(id, isAnswer(answer) ? answer : noAnswer, this.#path);
    }
    for (const program of this.#programs) {
      const text = Object.hasOwn(texts, program) ? texts[program] : undefined;
      if (text === undefined) forgetText(program);
      else keepText(program, text);
    }
  }
}

export const lessonsOf = (root: ParentNode): Lesson[] =>
  [...root.querySelectorAll<HTMLTableRowElement>("tr[data-lesson]")].map((row) => new Lesson(row));
