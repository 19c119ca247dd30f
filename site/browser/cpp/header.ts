/**
 * The precompiled header of the standard library, Eigen, MuJoCo and the helper header. With it, a
 * program takes a second or two and not a quarter of a minute. It is larger than all else, so it is
 * made where it is used, and kept.
 */
import { Files } from "./files.js";
import { prepareArguments, preparedHeader } from "./flags.js";
import { Tool } from "./tool.js";

/** Takes seconds. */
export function makeHeader(llvm: WebAssembly.Module, pack: Files): Uint8Array {
  const files = new Files(pack);
  const { ok, text } = new Tool(llvm).run(prepareArguments, files);
  if (!ok) throw new Error(`the header does not compile: ${text}`);
  return files.bytes(preparedHeader)!;
}
