/**
 * What an exercise's program checks of the reader's text: a mark for each check below the listing, the
 * first that fails on top, and what that means. Once all hold it is solved, which the browser remembers
 * as it does answers, so the exercise comes again in the review.
 */
import { make } from "../client/element.js";
import { recallAnswer, rememberAnswer } from "../client/quiz/answers.js";
import { reviewed } from "../client/quiz/schedule.js";
import type { End } from "../cpp/messages.js";
import { type Check, readChecks } from "./records.js";
import { closed, counted } from "./sentences.js";

type Mark = "fails" | "open" | "holds";

const signs: Readonly<Record<Mark, string>> = { fails: "✗", open: "–", holds: "✓" };
const words: Readonly<Record<Mark, string>> = {
  fails: "Fails: ",
  open: "Was not reached: ",
  holds: "Holds: ",
};

export class Exercise {
  readonly #id: string;
  readonly #list: HTMLElement;
  /** What each check says of itself, in the order in which the solution makes them. */
  readonly #names: readonly string[];

  private constructor(figure: HTMLElement, list: HTMLElement) {
    this.#id = figure.id;
    this.#list = list;
    this.#names = [...list.children].map((item) => item.textContent);
  }

  /** Undefined for a listing that is none. */
  static of(figure: HTMLElement): Exercise | undefined {
    const list = figure.querySelector<HTMLElement>(".checks ul");
    return list ? new Exercise(figure, list) : undefined;
  }

  /** As before the first run. */
  reset(): void {
    this.#list.replaceChildren(...this.#names.map((name) => make("li", {}, name)));
  }

  /** Shows what came of a run, and gives it in a sentence. */
  judge(end: End, records: string): string {
    const made = new Map(readChecks(records).map((check) => [check.what, check]));
    const markOf = (name: string): Mark => {
      const check = made.get(name);
      if (!check) return "open";
      return check.holds ? "holds" : "fails";
    };
    const sorted = (Object.keys(signs) as Mark[]).flatMap((mark) =>
      this.#names.filter((name) => markOf(name) === mark).map((name) => [name, mark] as const),
    );
    this.#list.replaceChildren(...sorted.map(([name, mark]) => item(name, mark, made.get(name))));
    const [first] = sorted;
    const held = sorted.filter(([, mark]) => mark === "holds").length;
    if (first && held < sorted.length) return notYet(held, sorted.length, first, made);
    if (end.how !== "exit" || end.code !== 0) return "All checks hold, but it has to end well.";
    this.#remember();
    return `Solved: ${sorted.length === 1 ? "the check holds" : `all ${sorted.length} checks hold`}.`;
  }

  #remember(): void {
    const before = recallAnswer(this.#id);
    const review = reviewed(before.review, true);
    rememberAnswer(this.#id, { ...before, given: ["passed"], review });
  }
}

function item(name: string, mark: Mark, check: Check | undefined): HTMLElement {
  const sign = make("span", { class: "check-sign", "aria-hidden": "true" }, signs[mark]);
  const word = make("span", { class: "unseen" }, words[mark]);
  const told = [check?.meaning, check?.found].filter((text) => text && mark === "fails");
  return make("li", { class: mark }, sign, word, name, ...told.map((text) => make("p", {}, text!)));
}

function notYet(
  held: number,
  all: number,
  [name, mark]: readonly [string, Mark],
  made: ReadonlyMap<string, Check>,
): string {
  const sentence = `${held} of ${counted(all, "check")} ${held === 1 ? "holds" : "hold"}. `;
  if (mark === "open") return `${sentence}The run did not get to “${name}”.`;
  const meaning = made.get(name)?.meaning;
  return closed(`${sentence}“${name}” does not${meaning ? `: ${meaning}` : ""}`);
}
