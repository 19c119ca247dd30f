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
import {
  functionsPath,
  linkArguments,
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
import { filesToCompile, filesToRun } from "./program-files.js";
import { runTool } from "./tool.js";
import type { Stream } from "./wasi.js";

export interface Parts {
  readonly llvm: WebAssembly.Module;
  readonly engine: EngineBinary;
  readonly pack: Files;
}

/** Hears of a run as it goes on. */
export interface Listener {
  readonly compiled: (ok: boolean, diagnostics: readonly Diagnostic[]) => void;
  readonly output: (stream: Stream, bytes: Uint8Array) => void;
}

export interface Finished {
  readonly end: End;
  readonly records: string;
  readonly model: LoadedModel | undefined;
  readonly seconds: { readonly compile: number; readonly link: number; readonly run: number };
}

const recordsPath = "/records";

export class Compiler {
  #isPrepared = false;

  private constructor(
    private readonly parts: Parts,
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
    return new Compiler(parts, base, engine.table.length);
  }

  /** Without one, a program takes many times as long. */
  useHeader(header: Uint8Array): void {
    this.base.put(preparedHeader, header);
    this.#isPrepared = true;
  }

  /** Gives nothing where the program does not compile. */
  async run(program: Program, listener: Listener): Promise<Finished | undefined> {
    const clock = new Stopwatch();
    const objects = this.#compile(program);
    const compile = clock.lap();
    const linked = objects.ok ? this.#link(objects.paths, objects) : { diagnostics: [] };
    const link = clock.lap();

    const { code } = linked;
    listener.compiled(code !== undefined, [...objects.diagnostics, ...linked.diagnostics]);
    if (code === undefined) return undefined;

    const files = filesToRun(program);
    let model: LoadedModel | undefined;
    const end = await execute(this.parts.engine, {
      module: new WebAssembly.Module(code as Uint8Array<ArrayBuffer>),
      args: [nameOf(program.main), ...(program.arguments ?? [])],
      env: { MJCOURSE_MODELS: modelsFolder, MJCOURSE_RECORDS: recordsPath },
      files,
      write: listener.output,
      loaded: (last) => (model = last),
    });
    const records = new TextDecoder().decode(files.bytes(recordsPath));
    return { end, records, model, seconds: { compile, link, run: clock.lap() } };
  }

  /** What a run has printed with what it is to print. */
  compare(printed: string, stated: readonly StatedOutput[]): Promise<OutputChanges> {
    return outputChanges(this.parts.engine, printed, stated);
  }

  #compile(program: Program) {
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
      const args = compileArguments(source, object, { include, prepared });
      const result = runTool(this.parts.llvm, args, files);
      diagnostics.push(...compilerDiagnostics(result.text, nameForReader));
      paths.push(object);
      ok &&= result.ok;
    }
    return { ok, files, paths, prepared, hasHandlers, diagnostics };
  }

  #link(
    objects: readonly string[],
    how: { readonly files: Files; readonly prepared: boolean; readonly hasHandlers: boolean },
  ): { readonly code?: Uint8Array; readonly diagnostics: readonly Diagnostic[] } {
    const out = "/program.wasm";
    const { prepared, hasHandlers } = how;
    const args = linkArguments({
      ...{ objects, out, prepared, hasHandlers },
      tableBegin: this.tableBegin,
    });
    const { ok, text } = runTool(this.parts.llvm, args, how.files);
    const code = how.files.bytes(out);
    return ok && code ? { code, diagnostics: [] } : { diagnostics: linkerDiagnostics(text) };
  }
}

/** A path of the program's as its zip has it, and of the others what an #include names. */
function nameForReader(path: string): string {
  const folders = [programFolder, "/include/eigen3", "/include", "/usr/include/c++/v1"];
  const folder = folders.find((one) => path.startsWith(`${one}/`));
  return folder === undefined ? path : path.slice(folder.length + 1);
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
