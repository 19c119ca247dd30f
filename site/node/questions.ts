/**
 * What the build asks of the page's compiler, and the answers to it. Enter with Respondent.answer().
 *
 *   compile   a program: whether it compiles, what is said of it, and the name of the linked module,
 *             which this process keeps for a while
 *   run       such a module, with the program's models and arguments: how it ended and what it wrote.
 *             Or that this process does not have the module (any more)
 *   place     a program, and the end and the offsets of a run of its module: the end with its line
 *
 * A question without a kind is a program to compile, run and place. A module's run depends on nothing
 * but its bytes, the models and the arguments, so programs that differ only in comments share it.
 */
import { withMain, type Compiler, type Finished } from "../browser/cpp/compiler.js";
import type { Diagnostic, End, Program } from "../browser/cpp/messages.js";
import type { Stream } from "../browser/cpp/wasi.js";
import { KeptModules } from "./kept-modules.js";

interface SentProgram extends Omit<Program, "files"> {
  readonly files: Readonly<Record<string, { readonly text: string } | { readonly base64: string }>>;
}

export type Question = SentProgram &
  (
    | { readonly kind?: undefined }
    | { readonly kind: "compile" }
    | { readonly kind: "run"; readonly module: string }
    | { readonly kind: "place"; readonly end: End; readonly offsets: readonly number[] }
  );

interface Compiled {
  readonly ok: boolean;
  readonly diagnostics: readonly Diagnostic[];
  /** Nothing where the program does not compile. */
  readonly module: string | null;
  readonly seconds: { readonly compile: number; readonly link: number };
}

interface Ran {
  readonly out: string;
  readonly err: string;
  readonly end: End;
  /** For `place`; none where an end has no place. */
  readonly offsets: readonly number[];
  readonly records: string;
  readonly seconds: { readonly run: number };
}

interface Unknown {
  readonly unknownModule: true;
}

interface Placed {
  readonly end: End;
}

interface CompiledAndRan extends Omit<Ran, "end" | "offsets" | "seconds"> {
  readonly ok: boolean;
  readonly diagnostics: readonly Diagnostic[];
  /** Nothing where the program does not compile. */
  readonly end: End | null;
  readonly seconds: {
    readonly compile: number;
    readonly link: number;
    readonly run: number;
  } | null;
}

export type Answer = Compiled | Ran | Unknown | Placed | CompiledAndRan;

export class Respondent {
  readonly #modules = new KeptModules();

  constructor(private readonly compiler: Compiler) {}

  async answer(question: Question): Promise<Answer> {
    const program = { ...question, files: decoded(question.files) };
    switch (question.kind) {
      case "compile":
        return this.#compile(program);
      case "run":
        return this.#run(question.module, program);
      case "place":
        return { end: this.#placed(question.end, question.offsets, program) };
      case undefined:
        return this.#compileAndRun(program);
    }
  }

  #compile(program: Program): Compiled {
    const { code, diagnostics, ...seconds } = this.compiler.build(program);
    const module = code ? this.#modules.keep(code) : null;
    return { ok: code !== undefined, diagnostics, module, seconds };
  }

  async #run(module: string, program: Program): Promise<Ran | Unknown> {
    const code = this.#modules.find(module);
    if (!code) return { unknownModule: true };
    const streams = new Streams();
    const finished = await this.compiler.execute(code, program, streams.write);
    const { end, records, seconds } = finished;
    const offsets = hasPlace(end) ? finished.offsets : [];
    return { ...streams.texts(), end, offsets, records, seconds: { run: seconds } };
  }

  async #compileAndRun(program: Program): Promise<CompiledAndRan> {
    const streams = new Streams();
    let told: Pick<Compiled, "ok" | "diagnostics"> = { ok: false, diagnostics: [] };
    const finished = await this.compiler.run(program, {
      compiled: (ok, diagnostics) => (told = { ok, diagnostics }),
      output: streams.write,
    });
    const { records = "", seconds = null } = finished ?? {};
    const end = finished ? this.#placed(finished.end, finished.offsets, program) : null;
    return { ...told, ...streams.texts(), end, records, seconds };
  }

  #placed(end: End, offsets: Finished["offsets"], program: Program): End {
    if (!hasPlace(end)) return end;
    const line = this.compiler.lineOf(offsets, program);
    return { ...withMain(end, program), ...(line === undefined ? {} : { line }) };
  }
}

/** Will somebody look for its line? A code is most often what the author expects. */
const hasPlace = ({ how }: End) => how !== "exit";

/** What a program writes. */
class Streams {
  readonly #pieces = { out: [] as Uint8Array[], err: [] as Uint8Array[] };

  readonly write = (stream: Stream, bytes: Uint8Array) => this.#pieces[stream].push(bytes);

  texts(): { readonly out: string; readonly err: string } {
    const text = (stream: Stream) => Buffer.concat(this.#pieces[stream]).toString("utf8");
    return { out: text("out"), err: text("err") };
  }
}

function decoded(files: SentProgram["files"]): Program["files"] {
  const content = (file: SentProgram["files"][string]) =>
    "text" in file ? file.text : Buffer.from(file.base64, "base64");
  return Object.fromEntries(Object.entries(files).map(([name, file]) => [name, content(file)]));
}
