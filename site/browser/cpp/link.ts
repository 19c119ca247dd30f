/**
 * Links a reader's program: it imports the engine's functions, memory and table, and lies at the
 * bottom of that memory (engine/wasm/program_api.h).
 */
import { preparedObjects } from "./flags.js";

/** The stack lies below a program's variables, so one that overflows runs out of memory at address 0
 * and is stopped there. */
export const stackSize = 4 << 20;

/** How many entries of the engine's table a program may have. */
export const tableRoom = 1 << 14;

/** Wasm objects and lists that Compiler.of() makes of an engine. */
export const variablesPath = "/runtime/variables.o";
export const functionsPath = "/runtime/functions.txt";

/** What a program imports besides MuJoCo's functions (execution.ts). */
export const programImports = ["mjc_no_memory", "mjc_abort", "mjc_throws", "mjc_thread_waits"];

/** Of runtime/, and the two of libc++abi that clang's package lacks. */
const runtime = [
  ...["memory", "new", "threads", "abort", "unwind", "uncaught", "library_throw"],
  ...["cxa_exception", "cxa_personality"],
];

export interface Linking {
  readonly objects: readonly string[];
  readonly out: string;
  /** Where the program's functions begin in the engine's table. */
  readonly tableBegin: number;
  /** Whether the precompiled header's objects take part. */
  readonly prepared: boolean;
  readonly hasHandlers: boolean;
  /** Whether the program says which code comes from which line. */
  readonly withLines: boolean;
}

export const linkArguments = (linking: Linking): string[] => [
  ...["wasm-ld", "-m", "wasm32", "--import-memory", "--import-table", "--growable-table"],
  ...[`--global-base=${stackSize}`, "-z", `stack-size=${stackSize}`],
  ...[`--table-base=${linking.tableBegin}`],
  ...[`--allow-undefined-file=${functionsPath}`, "--gc-sections"],
  ...(linking.withLines ? [] : ["--strip-debug"]),
  ...["mjc_uncaught", "__cpp_exception", "__stack_pointer", "__data_end"].map(
    (name) => `--export=${name}`,
  ),
  ...["/usr/lib/wasm32-wasip1/crt1-command.o", ...linking.objects],
  ...[...runtime, ...(linking.hasHandlers ? [] : ["handlers"])].map((name) => `/runtime/${name}.o`),
  ...[variablesPath, ...(linking.prepared ? preparedObjects : [])],
  ...["-L/usr/lib/wasm32-wasip1", "-lc++", "-lc++abi", "-lc"],
  ...["/usr/lib/wasm32-unknown-wasip1/libclang_rt.builtins.a", "-o", linking.out],
];

/**
 * A wasm object that says where the engine's variables lie: data symbols with absolute addresses, in
 * the form of WebAssembly's tool conventions (Linking.md, "Symbol table", WASM_SYMBOL_ABSOLUTE).
 */
export function variablesObject(places: ReadonlyMap<string, number>): Uint8Array {
  const dataKind = 1;
  const absolute = 0x200;
  const size = 4;
  const symbols = [...places].map(([name, place]) => [
    ...[dataKind, ...leb(absolute), ...text(name)],
    ...[...leb(0), ...leb(place), ...leb(size)],
  ]);
  const table = [...leb(symbols.length), ...symbols.flat()];
  const version = 2;
  const symbolTable = 8;
  const linking = [...text("linking"), version, symbolTable, ...leb(table.length), ...table];
  const customSection = 0;
  const head = [0x00, 0x61, 0x73, 0x6d, 0x01, 0x00, 0x00, 0x00];
  return new Uint8Array([...head, customSection, ...leb(linking.length), ...linking]);
}

/** An unsigned number in LEB128. */
function leb(number: number): number[] {
  const bytes: number[] = [];
  for (let rest = number; ; rest >>>= 7) {
    if (rest < 128) return [...bytes, rest];
    bytes.push((rest & 127) | 128);
  }
}

function text(value: string): number[] {
  const bytes = new TextEncoder().encode(value);
  return [...leb(bytes.length), ...bytes];
}
