/**
 * clang and the linker, which are one program of WASI: a fresh instance of it for each run. Enter with
 * Tool.run().
 *
 * The memory is kept, and zeroed before each run. A page of it that nobody touched before takes the
 * system many times as long as zeroing does, and the smallest program touches 68 MB. `llvm` imports it
 * for that (bundle/imported-memory.mjs).
 */
import { isStackOverflow } from "./exhausted.js";
import { Exit, wasi } from "./wasi.js";
import type { Files } from "./files.js";

export interface ToolResult {
  readonly ok: boolean;
  /** What it printed, on either stream. */
  readonly text: string;
}

/** As it says other errors (diagnostics.ts). */
const crashed = "\nerror: the compiler itself crashed on this program\n";
const tooDeep =
  "\nerror: this program is nested too deeply for the compiler: does a template name itself without end?\n";

/** What a small program takes, in pages of 64 KiB. */
const firstPages = (80 << 20) >> 16;
/** A memory that has grown beyond this is not kept. */
const mostBytes = 200 << 20;

export class Tool {
  #memory: WebAssembly.Memory | undefined;

  constructor(private readonly llvm: WebAssembly.Module) {}

  /** With the command line `args`, over `files`. It fails by its exit code, by a full stack or, where it has
   * a fault of its own, by a trap; another exception is of the machine's: there is no memory left. */
  run(args: readonly string[], files: Files): ToolResult {
    const decoder = new TextDecoder();
    let text = "";
    const memory = this.#zeroed();
    const imports = wasi({
      args,
      files,
      memory: () => memory,
      write: (_stream, bytes) => (text += decoder.decode(bytes, { stream: true })),
    });
    try {
      const instance = { env: { memory }, wasi_snapshot_preview1: imports };
      const { exports } = new WebAssembly.Instance(this.llvm, instance);
      (exports["heap_end"] as WebAssembly.Global<"i32">).value = memory.buffer.byteLength;
      (exports["_start"] as () => void)();
      return { ok: true, text };
    } catch (error) {
      if (isStackOverflow(error)) return { ok: false, text: text + tooDeep };
      if (error instanceof WebAssembly.RuntimeError) return { ok: false, text: text + crashed };
      if (!(error instanceof Exit)) throw error;
      return { ok: error.code === 0, text };
    } finally {
      this.#memory = memory.buffer.byteLength > mostBytes ? undefined : memory;
    }
  }

  #zeroed(): WebAssembly.Memory {
    if (!this.#memory) return new WebAssembly.Memory({ initial: firstPages });
    new Uint8Array(this.#memory.buffer).fill(0);
    return this.#memory;
  }
}
