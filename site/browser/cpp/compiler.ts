/**
 * Compiles and runs readers' programs: enter at Compiler.of(). It knows neither a page nor Node.
 *
 *   const compiler = await Compiler.of({ llvm, engine, pack });
 *   compiler.useHeader(kept ?? makeHeader(llvm, pack));
 *   const run = await compiler.run(program, { compiled, output });
 *
 * A program is compiled by clang, linked with the names and places of one engine, and run on a fresh
 * one, as these are the same in each.
 */
import { compilerDiagnostics, linkerDiagnostics } from "./diagnostics.js";
import { startEngine, type EngineBinary } from "./engine.js";
import { execute } from "./execution.js";
import { Files } from "./files.js";
import { compileArguments, modelsFolder, preparedHeader, programFolder } from "./flags.js";
import { LineTable } from "./line-table.js";
import {
  functionsPath,
  linkArguments,
  type Linking,
  programImports,
  variablesObject,
  variablesPath,
} from "./link.js";
import type {
  Diagnostic,
  End,
  LoadedModel,
  OutputChanges,
  Program,
  StatedOutput,
} from "./messages.js";
import { outputChanges } from "./output-changes.js";
import { asText, filesToCompile, filesToRun } from "./program-files.js";
import { Tool } from "./tool.js";
import type { Stream } from "./wasi.js";

export interface Parts {
  readonly llvm: WebAssembly.Module;
  readonly engine: EngineBinary;
  readonly pack: Files;
}

/** Makes objects sooner than the page's compiler can, and the same ones (node/compared-clang.ts). */
export interface QuickCompiler {
  /** What `args` compile to `object`, of `files`. Nothing where there is anything to say of the program: the
   * page's own compiler, `tool`, says it. */
  object(args: readonly string[], object: string, files: Files, tool: Tool): Uint8Array | undefined;
}

/** Hears of a run as it goes on. */
export interface Listener {
  readonly compiled: (ok: boolean, diagnostics: readonly Diagnostic[]) => void;
  readonly output: (stream: Stream, bytes: Uint8Array) => void;
}

export interface Finished {
  /** What was run, as the linker left it. */
  readonly code: Uint8Array;
  readonly end: End;
  /** For lineOf(). */
  readonly offsets: readonly number[];
  readonly records: string;
  readonly model: LoadedModel | undefined;
  readonly seconds: { readonly compile: number; readonly link: number; readonly run: number };
}

/** What came of compiling. */
interface Objects {
  readonly ok: boolean;
  readonly files: Files;
  readonly diagnostics: readonly Diagnostic[];
  readonly how: Omit<Linking, "out" | "tableBegin">;
}

/** The program that was compiled last. */
interface Built {
  readonly program: Program;
  /** Nothing where it does not compile. */
  readonly code: Uint8Array | undefined;
  readonly diagnostics: readonly Diagnostic[];
  /** Seconds. */
  readonly compile: number;
  readonly link: number;
}

const recordsPath = "/records";

export class Compiler {
  #isPrepared = false;
  #quick: QuickCompiler | undefined;
  #built: Built | undefined;

  private constructor(
    private readonly engine: EngineBinary,
    private readonly tool: Tool,
    /** The pack, the precompiled header and what is known of the engine. */
    private readonly base: Files,
    private readonly tableBegin: number,
  ) {}

  static async of(parts: Parts): Promise<Compiler> {
    const files = new Files();
    const engine = await startEngine(parts.engine, { args: [], files, write: () => undefined });
    const base = new Files(parts.pack);
    base.put(variablesPath, variablesObject(engine.variables));
    base.put(functionsPath, [...engine.functions.keys(), ...programImports].join("\n"));
    return new Compiler(parts.engine, new Tool(parts.llvm), base, engine.table.length);
  }

  /** Without one, a program takes many times as long. */
  useHeader(header: Uint8Array): void {
    this.base.put(preparedHeader, header);
    this.#isPrepared = true;
  }

  useQuickCompiler(quick: QuickCompiler): void {
    this.#quick = quick;
  }

  /** Gives nothing where the program does not compile. */
  async run(program: Program, listener: Listener): Promise<Finished | undefined> {
    const { code, diagnostics, compile, link } = this.#build(program);
    listener.compiled(code !== undefined, diagnostics);
    if (code === undefined) return undefined;
    const clock = new Stopwatch();
    const files = filesToRun(program);
    let model: LoadedModel | undefined;
    const { end, offsets } = await execute(this.engine, {
      module: new WebAssembly.Module(code as Uint8Array<ArrayBuffer>),
      args: [nameOf(program.main), ...(program.arguments ?? [])],
      env: { MJCOURSE_MODELS: modelsFolder, MJCOURSE_RECORDS: recordsPath },
      files,
      write: listener.output,
      loaded: (last) => (model = last),
    });
    const records = new TextDecoder().decode(files.bytes(recordsPath));
    const seconds = { compile, link, run: clock.lap() };
    return { code, end: withMain(end, program), offsets, records, model, seconds };
  }

  /**
   * The line of the program's source where a run of it was ended. It is compiled once more for that:
   * what says which line is which changes no code, but takes time.
   */
  lineOf(offsets: readonly number[], program: Program): number | undefined {
    if (offsets.length === 0) return undefined;
    const { code } = this.#link(this.#compile(program, true));
    const table = code && LineTable.of(code, program.main);
    for (const offset of table ? offsets : []) {
      const line = table!.lineAt(offset);
      if (line !== undefined) return line;
    }
    return undefined;
  }

  /** What a run has printed with what it is to print. */
  compare(printed: string, stated: readonly StatedOutput[]): Promise<OutputChanges> {
    return outputChanges(this.engine, printed, stated);
  }

  /** A program that is run again, perhaps with other arguments, is not compiled again. */
  #build(program: Program): Built {
    if (this.#built && areSame(this.#built.program, program)) {
      return { ...this.#built, compile: 0, link: 0 };
    }
    const clock = new Stopwatch();
    const objects = this.#compile(program);
    const compile = clock.lap();
    const { code, diagnostics } = this.#link(objects);
    const all = [...objects.diagnostics, ...diagnostics];
    this.#built = { program, code, diagnostics: all, compile, link: clock.lap() };
    return this.#built;
  }

  #compile(program: Program, withLines = false): Objects {
    const { files, sources, include, takesPrepared, hasHandlers } = filesToCompile(
      program,
      this.base,
    );
    const prepared = this.#isPrepared && takesPrepared;
    const diagnostics: Diagnostic[] = [];
    const paths: string[] = [];
    let ok = true;
    for (const [i, source] of sources.entries()) {
      const object = `/object/${i}.o`;
      files.addFolder("/object");
      const args = compileArguments(source, object, { include, prepared, withLines });
      // Which line is which only the page's own compiler is asked.
      const made = withLines ? undefined : this.#quick?.object(args, object, files, this.tool);
      if (made) {
        files.put(object, made);
        paths.push(object);
        continue;
      }
      const result = this.tool.run(args, files);
      diagnostics.push(...compilerDiagnostics(result, nameForReader));
      paths.push(object);
      ok &&= result.ok;
    }
    return { ok, files, diagnostics, how: { objects: paths, prepared, hasHandlers, withLines } };
  }

  #link({ ok: areObjects, files, how }: Objects): {
    readonly code?: Uint8Array;
    readonly diagnostics: readonly Diagnostic[];
  } {
    if (!areObjects) return { diagnostics: [] };
    const out = "/program.wasm";
    const args = linkArguments({ ...how, out, tableBegin: this.tableBegin });
    const { ok, text } = this.tool.run(args, files);
    const code = files.bytes(out);
    return ok && code ? { code, diagnostics: [] } : { diagnostics: linkerDiagnostics(text) };
  }
}

/** The linker puts a trap in the place of a main() that is missing. One that a macro or a header writes
 * is not seen here. */
function withMain(end: End, { main, files }: Program): End {
  const hasMain = /\bmain\s*\(/.test(asText(files[main] ?? ""));
  if (end.how !== "trap" || hasMain) return end;
  return { ...end, message: "it has no main(), where a program begins" };
}

/** A path of the program's as its zip has it, and of the others what an #include names. */
function nameForReader(path: string): string {
  const folders = [programFolder, "/include/eigen3", "/include", "/usr/include/c++/v1"];
  const folder = folders.find((one) => path.startsWith(`${one}/`));
  return folder === undefined ? path : path.slice(folder.length + 1);
}

/** Are they compiled of the same? Models are for the run. */
function areSame(one: Program, other: Program): boolean {
  const compiled = ({ files, models }: Program) =>
    Object.entries(files).filter(([name]) => !name.startsWith(`${models}/`));
  const files = compiled(one);
  return (
    one.main === other.main &&
    files.length === compiled(other).length &&
    files.every(([name, content]) => isSame(content, other.files[name]))
  );
}

function isSame(one: string | Uint8Array, other: string | Uint8Array | undefined): boolean {
  if (typeof one === "string" || typeof other === "string") return one === other;
  return one.length === other?.length && one.every((byte, i) => byte === other[i]);
}

const nameOf = (path: string) => path.slice(path.lastIndexOf("/") + 1).replace(/\.cpp$/, "");

class Stopwatch {
  #since = performance.now();

  /** Seconds since the last lap. */
  lap(): number {
    const now = performance.now();
    const seconds = (now - this.#since) / 1000;
    this.#since = now;
    return seconds;
  }
}
