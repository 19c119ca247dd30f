/**
 * Runs a linked program on an engine and says how it ended. Enter with execute().
 *
 * The program exports its stack pointer, what throws and mjc_uncaught() (runtime/uncaught.cpp). What
 * it imports besides MuJoCo are the functions of runtime/*.c that end it.
 */
import { startEngine, textAt, type Engine, type EngineBinary } from "./engine.js";
import { isOutOfMemory, isStackOverflow } from "./exhausted.js";
import type { Files } from "./files.js";
import { stackSize, tableRoom } from "./link.js";
import { loadedModel } from "./loaded-model.js";
import type { End, LoadedModel } from "./messages.js";
import { keepLongTraces, programOffsets } from "./stack-trace.js";
import { trap } from "./trap.js";
import type { Stream } from "./wasi.js";

/** As natively: of each stream. */
const mostOutput = 1 << 20;
/** As natively, too, in bytes. */
const largestFile = 32 << 20;
/** What engine and program may have together, in pages of 64 KiB. */
const mostPages = (1 << 30) >> 16;
/** How often a program may yield to other threads, of which a page has none. */
const mostYields = 1_000_000;

export interface Execution {
  readonly module: WebAssembly.Module;
  readonly args: readonly string[];
  readonly env: Readonly<Record<string, string>>;
  readonly files: Files;
  readonly write: (stream: Stream, bytes: Uint8Array) => void;
  readonly loaded: (model: LoadedModel) => void;
}

/** How a program ended, and in which calls (stack-trace.ts), where it did not return from main. */
export interface Ending {
  readonly end: End;
  readonly offsets: readonly number[];
}

export async function execute(binary: EngineBinary, execution: Execution): Promise<Ending> {
  keepLongTraces();
  const run = new RunningProgram(execution);
  const engine = await startEngine(binary, {
    args: execution.args,
    env: execution.env,
    files: execution.files,
    write: (stream, bytes) => run.write(stream, bytes),
    exit: (code) => run.stop({ how: "exit", code }),
    largestFile,
    full: () => run.stop({ how: "trap", message: "it wrote a file of more than 32 MiB" }),
  });
  return run.on(engine);
}

class RunningProgram {
  /** What a function said that ends the program, before it trapped. */
  #end: End | undefined;
  #hasNoMemory = false;
  #yields = 0;
  readonly #written = { out: 0, err: 0 };
  #lastError = "";
  /** Made where the last exception was thrown: what comes out of the program does not tell. */
  #throw: Error | undefined;

  constructor(private readonly execution: Execution) {}

  on(engine: Engine): Ending {
    capMemory(engine.memory, () => (this.#hasNoMemory = true));
    const { module } = this.execution;
    const imports = this.#imports(engine);
    const foreign = WebAssembly.Module.imports(module).find(
      ({ module, name }) => imports[module]?.[name] === undefined,
    );
    if (foreign) return { end: { how: "trap", message: hasNone(foreign) }, offsets: [] };
    let program: WebAssembly.Instance;
    try {
      engine.table.grow(tableRoom);
      program = new WebAssembly.Instance(module, imports);
    } catch (error) {
      const isForeign = error instanceof WebAssembly.LinkError && !isOutOfMemory(error);
      const how = isForeign ? "trap" : "memory";
      return { end: { how, message: messageOf(error) }, offsets: [] };
    }
    const { value: dataEnd } = program.exports["__data_end"] as WebAssembly.Global<"i32">;
    if (dataEnd > engine.room) {
      const message = "its global variables take more than 4 MiB";
      return { end: { how: "memory", message }, offsets: [] };
    }
    try {
      (program.exports["_start"] as () => void)();
      return { end: { how: "exit", code: 0 }, offsets: [] };
    } catch (error) {
      const thrown = this.#throw; // endOf() throws it once more
      const end = this.#end ?? endOf(error, program, engine);
      const place = end.how === "uncaught" ? thrown : error;
      return { end: this.#classify(end), offsets: programOffsets(stackOf(place)) };
    }
  }

  stop(end: End): never {
    this.#end ??= end;
    return trap();
  }

  write(stream: Stream, bytes: Uint8Array): void {
    const room = mostOutput - this.#written[stream];
    this.#written[stream] += bytes.length;
    this.execution.write(stream, bytes.subarray(0, room));
    if (stream === "err") this.#lastError = (this.#lastError + decode(bytes)).slice(-4096);
    if (bytes.length > room) this.stop({ how: "output", message: "It printed more than 1 MiB." });
  }

  #imports(engine: Engine): WebAssembly.Imports {
    const end = (how: "trap", message: string) => () => this.stop({ how, message });
    return {
      env: {
        memory: engine.memory,
        __indirect_function_table: engine.table,
        ...Object.fromEntries(engine.functions),
        mj_loadXML: this.#loadXml(engine),
        mjc_no_memory: () => (this.#hasNoMemory = true),
        mjc_abort: () => this.#abort(),
        mjc_throws: () => (this.#throw = new Error()),
        mjc_thread_waits: end("trap", threadWaits),
      },
      wasi_snapshot_preview1: {
        ...(engine.system as WebAssembly.ModuleImports),
        sched_yield: () =>
          ++this.#yields < mostYields ? 0 : this.stop({ how: "trap", message: threadWaits }),
      },
    };
  }

  /** As the engine's, and tells of it. */
  #loadXml({ functions, memory }: Engine) {
    const load = functions.get("mj_loadXML") as (...args: number[]) => number;
    const { files, loaded } = this.execution;
    return (file: number, vfs: number, ...rest: number[]): number => {
      const model = load(file, vfs, ...rest);
      if (model !== 0) loaded(loadedModel(memory, file, vfs, files));
      return model;
    };
  }

  /** What is at fault says so before, as assert() does. */
  #abort(): never {
    const said = lastLine(this.#lastError);
    return this.stop({ how: "trap", message: said || "it called abort()" });
  }

  /** The end of a program that could have no more memory is told by that, whatever came of it. */
  #classify(end: End): End {
    if (end.how === "exit") {
      const [, message] = /^MuJoCo error: (.*)$/m.exec(lastLine(this.#lastError)) ?? [];
      if (end.code !== mujocoErrorCode || message === undefined) return end;
      return this.#hasNoMemory ? { how: "memory", message } : { how: "error", message };
    }
    if (end.how === "output" || !this.#hasNoMemory) return end;
    return { how: "memory", message: end.message };
  }
}

/** With which mjcourse/handlers.cpp ends a program, after a line that says why. */
const mujocoErrorCode = 70;

const threadWaits = "a thread waits for another, and a page runs one after the other";

/** Of what came out of the program. */
function endOf(error: unknown, program: WebAssembly.Instance, engine: Engine): End {
  const { exports } = program;
  const tag = exports["__cpp_exception"] as unknown as WebAssembly.Tag;
  if (error instanceof WebAssembly.Exception && error.is(tag)) {
    const describe = exports["mjc_uncaught"] as (thrown: number) => number;
    return {
      how: "uncaught",
      message: textAt(engine.memory, describe(error.getArg(tag, 0) as number)),
    };
  }
  // emscripten throws C++'s exceptions as numbers
  if (typeof error === "number") return { how: "uncaught", message: engine.exceptionText(error) };
  if (isStackOverflow(error) || hasOverflown(program)) {
    return { how: "stack-overflow", message: "the stack is full" };
  }
  if (error instanceof WebAssembly.RuntimeError) {
    const { message } = error;
    return { how: "trap", message: /^unreachable/i.test(message) ? unreachable : message };
  }
  // of a call with an address or a size that nothing can have
  if (error instanceof RangeError) return { how: "trap", message: error.message };
  const { status } = error as { readonly status?: number }; // emscripten's ExitStatus
  if (typeof status === "number") return { how: "exit", code: status };
  throw error;
}

const hasNone = ({ module, name }: WebAssembly.ModuleImportDescriptor) =>
  `it imports “${name}” of “${module}”, which a page does not have`;

/** Where clang itself puts a trap. */
const unreachable = "a null pointer was followed, or a function ended without its return";

/** The stack grows down to address 0 and, as numbers of 32 bits do, on from the last one. */
function hasOverflown({ exports }: WebAssembly.Instance): boolean {
  const pointer = exports["__stack_pointer"] as WebAssembly.Global<"i32">;
  return pointer.value >>> 0 > stackSize;
}

function capMemory(memory: WebAssembly.Memory, refused: () => void): void {
  memory.grow = (pages) => {
    if (memory.buffer.byteLength / 65536 + pages > mostPages) {
      refused();
      throw new RangeError("a program may have 1 GiB");
    }
    return WebAssembly.Memory.prototype.grow.call(memory, pages);
  };
}

const decode = (bytes: Uint8Array) => new TextDecoder().decode(bytes);
const lastLine = (text: string) => text.trimEnd().split("\n").at(-1) ?? "";
const stackOf = (error: unknown) => (error as { readonly stack?: string } | undefined)?.stack ?? "";
const messageOf = (error: unknown) => (error instanceof Error ? error.message : String(error));
