// Offers to edit and run the programs of a lesson. The compiler is large, so the reader is asked first,
// with its size, unless this browser has it already. What happens then is in program/program.ts, which
// this script knows only by its address.

import { decoded } from "./decoded.js";
import { make } from "./element.js";
import { keptText } from "./program-text.js";
import { recallAnswer } from "./quiz/answers.js";

interface ProgramCode {
  readonly openProgram: (figure: HTMLElement, linked?: string) => Promise<void>;
}

const reasons = {
  file:
    "A program runs only on a page that a web server gave. In the site’s folder, run " +
    "“python3 -m http.server” and open http://localhost:8000.",
  noWebAssembly:
    "This browser has no WebAssembly, or it is switched off, so no program runs here. Another " +
    "browser may run it.",
  network: "What edits programs could not be loaded. Check the connection, then try again.",
} as const;

/** The reader has agreed on this page. */
let agreed = false;

const offers = new WeakMap<HTMLElement, Offer>();

class Offer {
  readonly #figure: HTMLElement;
  readonly #button = make("button", { type: "button", class: "edit-program" });
  readonly #place = make("div", { class: "program-offer" });
  readonly #status = make("p", { role: "status" });
  readonly #solved = make("span", { class: "solved" });
  #linked: string | undefined;

  constructor(figure: HTMLElement) {
    this.#figure = figure;
    this.#button.addEventListener("click", () => void this.open(this.#linked));
    this.#place.append(this.#status);
    figure.querySelector("figcaption")!.append(this.#solved, this.#button, this.#place);
    figure.addEventListener("program-closed", ({ detail }) => this.#comeBack(detail));
    this.#name();
  }

  /** `linked` is what a link has brought, for the program's own script to read. */
  async open(linked?: string): Promise<void> {
    this.#linked = linked;
    const reason = whyNot();
    const hasCompiler = agreed || (await this.#isKept());
    if (reason) this.#status.textContent = reason;
    else if (hasCompiler && linked === undefined) await this.#load();
    else this.#ask(hasCompiler);
  }

  #name(): void {
    const isOwn = keptText(this.#file) !== undefined;
    const [own, first] = this.#isExercise
      ? ["Go on with your version", "Solve it here"]
      : ["Edit and run your version", "Edit and run"];
    this.#button.textContent = isOwn ? own : first;
    this.#button.ariaLabel = `${this.#button.textContent}: ${this.#file}`;
    const isSolved = this.#isExercise && recallAnswer(this.#figure.id).given.length > 0;
    this.#solved.textContent = isSolved ? "Solved" : "";
  }

  #comeBack(focuses: boolean): void {
    this.#linked = undefined;
    this.#name();
    this.#button.hidden = false;
    if (focuses) this.#button.focus();
  }

  #ask(hasCompiler: boolean): void {
    if (this.#place.querySelector("button")) return;
    const yes = hasCompiler ? "Open the link’s text" : "Fetch the compiler";
    const fetchIt = make("button", { type: "button", class: "plain-button" }, yes);
    const notNow = make("button", { type: "button", class: "plain-button" }, "Not now");
    const answers = make("p", { class: "program-answers" }, fetchIt, " ", notNow);
    const answer = (act: () => void) => () => {
      answers.remove();
      this.#status.textContent = "";
      act();
    };
    fetchIt.addEventListener(
      "click",
      answer(() => {
        agreed = true;
        void this.#load();
      }),
    );
    notNow.addEventListener(
      "click",
      answer(() => this.#button.focus()),
    );
    this.#status.textContent =
      this.#wordsOnLink +
      (hasCompiler ? "Nothing of it runs before you say so." : this.#wordsOnFetching);
    this.#place.append(answers);
    // Where nobody asked, no key is to agree by mistake.
    if (this.#linked === undefined || this.#button.matches(":focus")) fetchIt.focus();
  }

  get #wordsOnLink(): string {
    if (this.#linked === undefined) return "";
    const size = `${(this.#linked.length / 1000).toFixed(1)} kB`;
    return `The link brought a text of this program, packed in ${size}, that somebody else may have written. `;
  }

  get #wordsOnFetching(): string {
    return (
      `To run it here, this page fetches a C++ compiler: ${this.#megabytes} MB, once; then it works ` +
      "without a network. What you write stays in this browser."
    );
  }

  async #load(): Promise<void> {
    const address = new URL(this.#figure.dataset["code"]!, document.baseURI).href;
    this.#button.ariaBusy = "true";
    this.#status.textContent = "Loading the editor…";
    try {
      const { openProgram } = (await import(address)) as ProgramCode;
      await openProgram(this.#figure, this.#linked);
      this.#button.hidden = true;
      this.#status.textContent = "";
    } catch (cause) {
      reportError(cause);
      this.#status.textContent = reasons.network;
    } finally {
      this.#button.ariaBusy = null;
    }
  }

  /** By the site's worker, so nothing large is to be fetched. */
  async #isKept(): Promise<boolean> {
    const address = new URL(this.#figure.dataset["llvm"]!, document.baseURI).href;
    try {
      return (await caches.match(address)) !== undefined;
    } catch {
      return false; // there are none, or the browser lets the site keep nothing
    }
  }

  get #isExercise(): boolean {
    return this.#figure.dataset["region"] !== undefined;
  }

  get #file(): string {
    return this.#figure.dataset["program"]!;
  }

  get #megabytes(): number {
    return Math.ceil(Number(this.#figure.dataset["bytes"]) / 1e6);
  }
}

declare global {
  interface HTMLElementEventMap {
    /** A program's listing is as it was; whether the reader asked for that. */
    "program-closed": CustomEvent<boolean>;
  }
}

function whyNot(): string | undefined {
  if (location.protocol === "file:") return reasons.file;
  if (typeof WebAssembly !== "object") return reasons.noWebAssembly;
  return undefined;
}

/** Of those in `root`, which is one itself or has them. */
export function offerPrograms(root: Document | Element = document): void {
  const programs = ".example[data-program]";
  const own = root instanceof HTMLElement && root.matches(programs) ? [root] : [];
  for (const figure of [...own, ...root.querySelectorAll<HTMLElement>(programs)]) {
    if (!offers.has(figure)) offers.set(figure, new Offer(figure));
  }
}

/** And those that the page makes of a lab's state (program/state-program.ts), which are opened at once. */
export function offerMadePrograms(): void {
  document.addEventListener("program-made", ({ target }) => {
    if (!(target instanceof HTMLElement)) return;
    offerPrograms(target);
    void offers.get(target)?.open();
  });
}

/** The program of a link that has a text of it (program/program-link.ts). */
export function openLinked(): void {
  const [, file, text] = /^#run:(.+):([\w-]+)$/.exec(decoded(location.hash)) ?? [];
  if (!file || !text) return;
  const figure = document.querySelector<HTMLElement>(
    `.example[data-program="${CSS.escape(file)}"]`,
  );
  if (!figure) return;
  figure.scrollIntoView();
  void offers.get(figure)?.open(text);
}
