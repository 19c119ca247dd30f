/**
 * What emscripten's engine.mjs gives: the functions of wasm/*.h and exported_functions.txt, and the
 * memory that they work on. Only this folder sees it.
 */

/** A pointer into the engine's memory; 0 is C's NULL. */
export type Pointer = number;

/** A function of C: numbers in, a number out; what returns nothing gives undefined. */
export type CFunction = (...args: number[]) => number;

export interface Glue {
  /** The memory's bytes. When memory grows this is another array, and every older view is empty. */
  readonly HEAPU8: Uint8Array<ArrayBuffer>;
  readonly UTF8ToString: (text: Pointer) => string;
  readonly stackSave: () => number;
  readonly stackRestore: (stack: number) => void;
  readonly [name: `_${string}`]: CFunction | undefined;
}

/** Where the engine comes from: an address for the browser, or the bytes themselves. */
export interface Source {
  /** Address of engine.mjs. */
  readonly glue: string;
  /** Address of engine.wasm. */
  readonly wasm?: string;
  readonly wasmBinary?: ArrayBuffer | Uint8Array;
}

interface GlueModule {
  readonly default: (options: object) => Promise<Glue>;
}

export async function loadGlue({ glue, wasm, wasmBinary }: Source): Promise<Glue> {
  const module = (await import(glue)) as GlueModule;
  return module.default({
    ...(wasmBinary === undefined ? {} : { wasmBinary }),
    ...(wasm === undefined ? {} : { locateFile: () => wasm }),
  });
}
