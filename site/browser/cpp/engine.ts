/**
 * The page's MuJoCo as the home of a program: each run has a fresh instance of it, whose memory and
 * table are the program's too (engine/wasm/program_api.h). Enter with EngineBinary.startEngine().
 */
import type { System } from "./wasi.js";
import { wasi } from "./wasi.js";

/** What emscripten's engine.mjs has, of which this knows what it needs. */
interface Glue {
  readonly _mjc_functions: () => number;
  readonly _mjc_variables: () => number;
  readonly _mjc_program_room: () => number;
  readonly _mjc_exception_text: (exception: number) => number;
  readonly _mjc_output_changes: (...texts: number[]) => number;
  readonly _malloc: (size: number) => number;
  readonly stackSave: () => number;
}

export type EngineFactory = (options: object) => Promise<Glue>;

export interface EngineBinary {
  /** The default export of engine.mjs. */
  readonly factory: EngineFactory;
  readonly module: WebAssembly.Module;
}

export interface Engine {
  readonly memory: WebAssembly.Memory;
  readonly table: WebAssembly.Table;
  readonly functions: ReadonlyMap<string, WebAssembly.ExportValue>;
  /** MuJoCo's variables, by where they lie. */
  readonly variables: ReadonlyMap<string, number>;
  /** Where the program's part of the memory ends. */
  readonly room: number;
  /** The functions of WASI, for the program. */
  readonly system: ReturnType<typeof wasi>;
  /** What a C++ exception of the engine's says. */
  readonly exceptionText: (exception: number) => string;
  /** What wasm/output_changes.h says of two texts; a tolerance below 0 is none. */
  readonly outputChanges: (stated: string, real: string, tolerance: number) => string;
}

/** `System` without the memory, which is the engine's. */
export async function startEngine(
  { factory, module }: EngineBinary,
  host: Omit<System, "memory">,
): Promise<Engine> {
  let memory: WebAssembly.Memory | undefined;
  let table: WebAssembly.Table | undefined;
  const system = wasi({ ...host, memory: () => memory! });
  const glue = await factory({
    instantiateWasm(imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance) => void) {
      const instance = new WebAssembly.Instance(module, imports);
      for (const value of Object.values(instance.exports)) {
        if (value instanceof WebAssembly.Memory) memory = value;
        if (value instanceof WebAssembly.Table) table = value;
      }
      done(instance);
      return instance.exports;
    },
    files: { ...system, open: (path: number, flags: number) => open(path, flags) },
  });
  const open = opener(system, () => memory!, glue);

  const symbols = symbolReader(memory!);
  return {
    memory: memory!,
    table: table!,
    functions: new Map(
      [...symbols(glue._mjc_functions())].map(([name, index]) => [
        name,
        table!.get(index) as WebAssembly.ExportValue,
      ]),
    ),
    variables: symbols(glue._mjc_variables()),
    room: glue._mjc_program_room(),
    system,
    exceptionText: (exception) => textAt(memory!, glue._mjc_exception_text(exception)),
    outputChanges: (...texts) => outputChanges(memory!, glue, ...texts),
  };
}

/** The copies of the texts go with the engine. */
function outputChanges(
  memory: WebAssembly.Memory,
  glue: Glue,
  stated: string,
  real: string,
  tolerance: number,
): string {
  const copies = [stated, real].flatMap((text) => {
    const bytes = new TextEncoder().encode(text);
    const copy = glue._malloc(bytes.length);
    new Uint8Array(memory.buffer).set(bytes, copy);
    return [copy, bytes.length];
  });
  return textAt(memory, glue._mjc_output_changes(...copies, tolerance));
}

/** C's open(), of path_open: gives a descriptor or an error below 0. */
function opener(system: ReturnType<typeof wasi>, memory: () => WebAssembly.Memory, glue: Glue) {
  const Flag = { access: 3, create: 0o100, exclusive: 0o200, truncate: 0o1000, append: 0o2000 };
  const Right = { read: 2n, write: 64n };
  const has = (flags: number, flag: number, bit: number) => ((flags & flag) === 0 ? 0 : bit);
  const pathOpen = system["path_open"] as (...args: (number | bigint)[]) => number;

  return (path: number, flags: number): number => {
    const how =
      has(flags, Flag.create, 1) | has(flags, Flag.exclusive, 4) | has(flags, Flag.truncate, 8);
    const rights = (flags & Flag.access) === 0 ? Right.read : Right.read | Right.write;
    const out = (glue.stackSave() - 16) & ~7; // below the stack, which nobody uses meanwhile
    const length = lengthAt(memory(), path);
    const append = has(flags, Flag.append, 1);
    const error = pathOpen(3, 0, path, length, how, rights, 0n, append, out);
    return error === 0 ? new DataView(memory().buffer).getUint32(out, true) : -error;
  };
}

/** Reads an array of mjcSymbol. */
function symbolReader(memory: WebAssembly.Memory) {
  return (first: number): Map<string, number> => {
    const view = new DataView(memory.buffer);
    const found = new Map<string, number>();
    for (let at = first; view.getUint32(at, true) !== 0; at += 8) {
      found.set(textAt(memory, view.getUint32(at, true)), view.getUint32(at + 4, true));
    }
    return found;
  };
}

const lengthAt = ({ buffer }: WebAssembly.Memory, at: number) =>
  new Uint8Array(buffer, at).indexOf(0);

/** The text at an address, up to its zero. */
export const textAt = (memory: WebAssembly.Memory, at: number) =>
  new TextDecoder().decode(new Uint8Array(memory.buffer).slice(at, at + lengthAt(memory, at)));
