/**
 * A listing that is edited: the editor in the place of the code, what can be done with it, and what the
 * reader's run printed above what the lesson's printed.
 */
import { make } from "../client/element.js";
import { forgetText, keepText, keptText } from "../client/program-text.js";
import type { Diagnostic, End, OutputChanges, StatedOutput } from "../cpp/messages.js";
import { type CodeEditor, openCodeEditor } from "./code-editor.js";
import { type ApiName, completionOf } from "./completion.js";
import { type Compiler, type Ended, type Listener, NoCompiler } from "./compiler.js";
import { diagnosticOfLine, lineOf } from "./diagnostics.js";
import { EndedLab } from "./ended-lab.js";
import { Exercise } from "./exercise.js";
import type { Folder } from "./folder.js";
import { keepFiles } from "./offline.js";
import { Output } from "./output.js";
import { encodeText } from "./program-link.js";
import { ProgressBar } from "./progress.js";
import { quoteLesson, quoteRun } from "./quotations.js";
import { readSnapshots } from "./records.js";
import { save } from "./save.js";
import { comparisonSentence, counted, sentenceOf } from "./sentences.js";
import { Solution } from "./solution.js";

const refusals: Readonly<Record<NoCompiler["why"], string>> = {
  network: "The compiler could not be loaded. Check the connection, then press Run.",
  memory:
    "There is no memory for the compiler: close other pages and press Run, or open this page on a " +
    "larger device.",
  unknown: "The compiler failed, and the browser’s console tells why.",
  stopped: "Stopped.",
};

/** It was none of the compiler's. */
const failed = "This page failed, and the browser’s console tells why.";

const borrowed =
  "What you change in it is not kept, as you have a text of your own: close this one to edit that.";

export class Panel {
  readonly #figure: HTMLElement;
  readonly #file: string;
  readonly #folder: Folder;
  readonly #compiler: Compiler;
  readonly #element = make("div", { class: "program" });
  readonly #host = make("div", { class: "program-editor" });
  readonly #status = make("p", { class: "program-status", role: "status" });
  readonly #progress = new ProgressBar((text) => this.#say(text));
  readonly #output = new Output();
  readonly #ended: EndedLab;
  readonly #exercise: Exercise | undefined;
  readonly #solution: Solution | undefined;
  readonly #run: HTMLButtonElement;
  readonly #stop = button("Stop", "", () => this.#compiler.stop());
  readonly #reset: HTMLButtonElement;
  readonly #leaving = new AbortController();
  #editor!: CodeEditor;
  /** Of the text that ran. */
  #diagnostics: readonly Diagnostic[] = [];
  /** What is kept, or need not be: a link's text is not the reader's own before it is changed. */
  #known = "";
  #isBusy = false;
  /** A link's text where the reader has an own one, in whose place it is not to come. */
  #isBorrowed = false;

  constructor(figure: HTMLElement, file: string, folder: Folder, compiler: Compiler) {
    this.#figure = figure;
    this.#file = file;
    this.#folder = folder;
    this.#compiler = compiler;
    this.#exercise = Exercise.of(figure);
    const { solution, region } = figure.dataset;
    if (solution && region) this.#solution = new Solution(solution, region);
    const run = this.#exercise ? "Run and check" : "Run";
    this.#run = button(run, "primary", () => void this.run());
    this.#reset = button(`Reset to ${this.#source}`, "", () => this.reset());
    this.#ended = new EndedLab(figure, this.#name, (text) => this.#say(text));
  }

  /** With `linked`, a text that is not the reader's own, and that is not kept before it is changed.
   * `remark` is told once it can be run. */
  open(linked?: string, remark = ""): void {
    const close = button("Close", "", () => this.close(true));
    const bar = make("div", { class: "program-bar" });
    this.#run.setAttribute("aria-keyshortcuts", "Control+Enter");
    this.#run.title = "Ctrl-Enter in the editor";
    bar.append(this.#run, this.#stop, this.#reset);
    if (this.#folder.isOfLesson) {
      bar.append(button("Copy link", "", () => void this.#copyLink()));
    }
    if (this.#solution) {
      bar.append(button("Compare with the solution", "", () => void this.#compare()));
    }
    bar.append(close, this.#progress.element);
    this.#element.append(this.#host, bar, this.#status);
    this.#code.before(this.#element);
    this.#code.hidden = true;
    this.#element.after(this.#output.element, this.#ended.element);
    if (this.#solution) this.#output.element.before(this.#solution.element);
    this.#figure.classList.add("edited");
    const lesson = this.#folder.text;
    const own = keptText(this.#file);
    this.#isBorrowed = linked !== undefined && own !== undefined && own !== linked;
    this.#known = linked ?? own ?? lesson;
    this.#editor = openCodeEditor(this.#host, {
      text: this.#known,
      file: this.#main,
      onChange: (text) => this.#changed(text),
      run: () => void this.run(),
      completion: completionOf(() => this.#apiNames(), this.#folder.helper),
    });
    const { region } = this.#figure.dataset;
    const shown = region ? `// #region ${region}\n` : this.#code.textContent;
    this.#editor.scrollTo(lineOfRegion(lesson, shown));
    this.#listen();
    this.#show();
    this.#editor.focus();
    void this.#prepare(this.#isBorrowed ? `${remark} ${borrowed}` : remark);
  }

  #listen(): void {
    const { signal } = this.#leaving;
    const keep = () => this.#changed(this.#editor.text);
    addEventListener("pagehide", keep, { signal });
    document.addEventListener("visibilitychange", keep, { signal });
    this.#zip?.addEventListener("click", (event) => this.#takeAlong(event), { signal });
    this.#download?.addEventListener("click", (event) => this.#saveText(event), { signal });
  }

  /** The listing is as it was; the reader's text stays kept. */
  close(focuses = false): void {
    if (this.#isBusy) this.#compiler.stop();
    this.#changed(this.#editor.text);
    this.#leaving.abort();
    this.#editor.destroy();
    this.#element.remove();
    this.#output.element.remove();
    this.#ended.close();
    this.#ended.element.remove();
    this.#solution?.element.remove();
    this.#exercise?.reset();
    this.#code.hidden = false;
    this.#figure.classList.remove("edited");
    quoteLesson(this.#name);
    this.#figure.dispatchEvent(new CustomEvent("program-closed", { detail: focuses }));
  }

  async run(): Promise<void> {
    if (this.#isBusy) return;
    if (this.#compiler.isRunning) {
      this.#say("Another program of this page is running. Stop it first.");
      return;
    }
    const { text } = this.#editor;
    this.#changed(text);
    this.#forgetRun();
    this.#editor.showDiagnostics([]);
    await this.#whileBusy(async () => {
      this.#say("Compiling…");
      this.#showStatus();
      await this.#compiler.open(this.#progress.show);
      this.#progress.hide();
      this.#say("Compiling…"); // opening may have said what it did
      const program = this.#folder.program(text, this.#arguments);
      const ended = await this.#compiler.run(program, this.#stated, this.#listener());
      if (ended) this.#tell(ended);
      else quoteLesson(this.#name);
    });
  }

  reset(): void {
    if (this.#isBusy) this.#compiler.stop();
    this.#isBorrowed = false;
    this.#known = this.#folder.text;
    this.#editor.replace(this.#known);
    this.#editor.showDiagnostics([]);
    forgetText(this.#file);
    this.#forgetRun();
    quoteLesson(this.#name);
    this.#show();
    this.#editor.focus();
    this.#say(
      this.#exercise ? "This is the starter again." : `This is ${this.#source} program again.`,
    );
  }

  #forgetRun(): void {
    this.#exercise?.reset();
    this.#solution?.hide();
    this.#output.clear();
    this.#ended.close();
  }

  /** While the reader reads and edits. */
  #prepare(remark: string): Promise<void> {
    return this.#whileBusy(async () => {
      await this.#compiler.open(this.#progress.show);
      this.#say(`Ready to run. ${remark}`.trim());
      const { worker, llvm, pack, engine, wasm } = this.#figure.dataset;
      void keepFiles([worker!, llvm!, pack!, engine!, wasm!]);
    });
  }

  async #whileBusy(work: () => Promise<void>): Promise<void> {
    this.#isBusy = true;
    this.#show();
    try {
      await work();
    } catch (error) {
      this.#refuse(error);
    } finally {
      this.#isBusy = false;
      this.#progress.hide();
      this.#show();
    }
  }

  #refuse(error: unknown): void {
    const why = error instanceof NoCompiler ? error.why : undefined;
    if (why === undefined || why === "unknown") reportError(error);
    quoteLesson(this.#name);
    this.#say(why === undefined ? failed : refusals[why]);
  }

  #listener(): Listener {
    return {
      compiled: ({ diagnostics, ok }) => {
        this.#showDiagnostics(diagnostics);
        this.#output.title = ok ? "Printed by your run" : "Said by the compiler";
        this.#say(ok ? "Running…" : `It does not compile: ${countOf(diagnostics)}.`);
        if (!ok) this.#showFirstError();
      },
      output: (stream, text) =>
        stream === "out" ? this.#output.print(text) : this.#output.complain(text),
    };
  }

  #showDiagnostics(diagnostics: readonly Diagnostic[]): void {
    this.#diagnostics = diagnostics;
    this.#editor.showDiagnostics(diagnostics);
    for (const one of diagnostics) this.#output.complain(`${lineOf(one)}\n`);
  }

  #showFirstError(): void {
    const isError = ({ file, severity }: Diagnostic) => file === this.#main && severity === "error";
    const first = this.#diagnostics.find(isError);
    if (first) this.#editor.scrollTo(first.line);
  }

  #tell({ end, records, model, changes, seconds }: Ended): void {
    const expected = Number(this.#figure.dataset["exit"] ?? 0);
    const told = [sentenceOf(end, expected)];
    if (this.#exercise) this.#judge(this.#exercise, end, records, told);
    const isExpected = end.how === "exit" && end.code === expected;
    if (end.line !== undefined && !isExpected) {
      const mark = diagnosticOfLine(this.#main, end.line, told[0]!);
      this.#editor.showDiagnostics([...this.#diagnostics, mark]);
      this.#editor.scrollTo(end.line);
    }
    if (changes && !this.#exercise) told.push(...this.#compareWithLesson(changes, records));
    const snapshots = readSnapshots(records);
    if (model && snapshots.size > 0) {
      this.#ended.offer({ snapshots, model, files: this.#folder.models });
    }
    if (seconds >= 1) told.push(`It ran for ${seconds.toFixed(1)} s.`);
    this.#say(told.join(" "));
    // It may have more lines than before.
    if (this.#figure.contains(document.activeElement)) this.#showStatus();
  }

  /** That it ran to the end goes without saying. */
  #judge(exercise: Exercise, end: End, records: string, told: string[]): void {
    const sentence = exercise.judge(end, records);
    if (end.how === "exit" && end.code === 0) told.length = 0;
    told.unshift(sentence);
  }

  async #compare(): Promise<void> {
    try {
      await this.#solution!.show(this.#editor.text);
      this.#solution!.element.scrollIntoView({ block: "nearest" });
      this.#say("The solution stands beside what you wrote.");
    } catch (error) {
      reportError(error);
      this.#say("The solution could not be loaded. Check the connection, then try again.");
    }
  }

  #showStatus(): void {
    this.#status.scrollIntoView({ block: "nearest" });
  }

  #compareWithLesson(changes: OutputChanges, records: string): string[] {
    this.#output.mark(changes.come);
    const values = quoteRun(this.#name, records);
    const come = values === 1 ? "comes" : "come";
    return [
      comparisonSentence(changes),
      ...(values > 0 ? [`${counted(values, "value")} in the text ${come} from your run.`] : []),
    ];
  }

  /** What the lesson says of the output comes first, then what its run printed. */
  get #stated(): readonly StatedOutput[] {
    if (!this.#folder.isOfLesson || this.#exercise) return [];
    const stated = JSON.parse(this.#figure.dataset["outputs"] ?? "[]") as StatedOutput[];
    return [...stated, { text: this.#folder.output, tolerance: null }];
  }

  #changed(text: string): void {
    if (text === this.#known) return;
    this.#known = text;
    this.#show();
    if (this.#isBorrowed) return;
    forgetLink();
    if (text === this.#folder.text) forgetText(this.#file);
    else keepText(this.#file, text);
  }

  /** What can be pressed now; the focus stays on what can. */
  #show(): void {
    const [possible, other] = this.#isBusy ? [this.#stop, this.#run] : [this.#run, this.#stop];
    possible.disabled = false;
    if (document.activeElement === other) possible.focus();
    other.disabled = true;
    this.#reset.disabled = this.#editor.text === this.#folder.text;
  }

  async #copyLink(): Promise<void> {
    const value = await encodeText(this.#editor.text);
    if (value === undefined) {
      this.#say("The program is too long for a link. “Zip to build” takes it along.");
      return;
    }
    const link = new URL(location.href);
    link.hash = `run:${this.#file}:${value}`;
    try {
      await navigator.clipboard.writeText(link.href);
      this.#say("The link is copied. Anyone who opens it gets this text and can run it.");
    } catch {
      location.hash = link.hash;
      this.#say("The link is this page’s address now: copy it from there.");
    }
  }

  #takeAlong(event: Event): void {
    const { text } = this.#editor;
    if (text === this.#folder.text) return;
    event.preventDefault();
    void this.#folder.zip(text).then((archive) => save(archive, `${this.#name}.zip`));
  }

  #saveText(event: Event): void {
    event.preventDefault();
    save(new Blob([this.#editor.text], { type: "text/plain" }), this.#main);
  }

  #say(text: string): void {
    this.#status.textContent = text;
  }

  get #code(): HTMLElement {
    return this.#figure.querySelector<HTMLElement>(":scope > .code")!;
  }

  /** A program that the page has made has none. */
  get #zip(): HTMLAnchorElement | null {
    return this.#figure.querySelector<HTMLAnchorElement>("a.zip");
  }

  /** Of the .cpp alone. */
  get #download(): HTMLAnchorElement | null {
    return this.#figure.querySelector<HTMLAnchorElement>("figcaption > a[download]:not(.zip)");
  }

  /** What it was at first. */
  get #source(): string {
    if (this.#exercise) return "the starter";
    return this.#folder.isOfLesson ? "the lesson’s" : "the lab’s";
  }

  /** As lessons quote it: "l0_1_parabola". */
  get #name(): string {
    return this.#main.replace(/\.cpp$/, "");
  }

  get #main(): string {
    return this.#file.slice(this.#file.lastIndexOf("/") + 1);
  }

  /** The site's index of MuJoCo's names. */
  async #apiNames(): Promise<readonly ApiName[]> {
    const code = new URL(this.#figure.dataset["code"]!, document.baseURI);
    const response = await fetch(new URL("../api-names.json", code));
    return (await response.json()) as readonly ApiName[];
  }

  get #arguments(): readonly string[] {
    return JSON.parse(this.#figure.dataset["arguments"] ?? "[]") as string[];
  }
}

/** Opened again, the page has what the reader made of the link's text. */
function forgetLink(): void {
  if (!location.hash.startsWith("#run:")) return;
  history.replaceState(history.state, "", location.pathname + location.search);
}

function button(name: string, kind: string, act: () => void): HTMLButtonElement {
  const made = make("button", { type: "button", class: `plain-button ${kind}`.trim() }, name);
  made.addEventListener("click", act);
  return made;
}

function countOf(diagnostics: readonly Diagnostic[]): string {
  return counted(diagnostics.filter(({ severity }) => severity === "error").length, "error");
}

/** A listing may show a part of the program: where that begins. */
function lineOfRegion(program: string, shown: string): number {
  const first = shown.split("\n").find((line) => line.trim() !== "") ?? "";
  return program.split("\n").findIndex((line) => line.endsWith(first)) + 1;
}
