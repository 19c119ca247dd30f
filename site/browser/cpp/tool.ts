/** clang and the linker, which are one program of WASI: a fresh instance of it for each run. */
import { Exit, wasi } from "./wasi.js";
import type { Files } from "./files.js";

export interface ToolResult {
  readonly ok: boolean;
  /** What it printed, on either stream. */
  readonly text: string;
}

/** As it says other errors (diagnostics.ts). */
const crashed = "\nerror: the compiler itself crashed on this program\n";

/** Runs `llvm` with the command line `args`, over `files`. It fails by its exit code or, where it has a
 * fault of its own, by a trap; another exception is of the machine's: there is no memory left. */
export function runTool(
  llvm: WebAssembly.Module,
  args: readonly string[],
  files: Files,
): ToolResult {
  const decoder = new TextDecoder();
  let text = "";
  const imports = wasi({
    args,
    files,
    memory: () => exports["memory"] as WebAssembly.Memory,
    write: (_stream, bytes) => (text += decoder.decode(bytes, { stream: true })),
  });
  const { exports } = new WebAssembly.Instance(llvm, { wasi_snapshot_preview1: imports });
  try {
    (exports["_start"] as () => void)();
    return { ok: true, text };
  } catch (error) {
    if (error instanceof WebAssembly.RuntimeError) return { ok: false, text: text + crashed };
    if (!(error instanceof Exit)) throw error;
    return { ok: error.code === 0, text };
  }
}
