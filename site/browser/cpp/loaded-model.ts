/**
 * Which model a program has loaded, for the page to show it: enter with loadedModel(). The files that it
 * names are the program's own; what the program itself put into MuJoCo's virtual file system is read there.
 */
import { textAt } from "./engine.js";
import type { Files } from "./files.js";
import type { LoadedModel } from "./messages.js";

/** mjVFS (mjmodel.h) for pointers of 32 bits: nfile, filename, filesize, filedata. */
const mostFiles = 2000;
const nameSize = 1000;
const names = 4;
const sizes = names + mostFiles * nameSize;
const contents = sizes + mostFiles * 4;

/** `file` and `vfs` are what mj_loadXML was called with, addresses in `memory`; without a virtual file
 * system, `vfs` is 0. */
export function loadedModel(
  memory: WebAssembly.Memory,
  file: number,
  vfs: number,
  files: Files,
): LoadedModel {
  const path = textAt(memory, file);
  const name = path.slice(path.lastIndexOf("/") + 1);
  const virtual = vfs === 0 ? {} : filesIn(memory, vfs);
  const own = files.bytes(path);
  return { name, files: { ...(own ? { [name]: own.slice() } : {}), ...virtual } };
}

function filesIn(memory: WebAssembly.Memory, vfs: number): Record<string, Uint8Array> {
  const { buffer } = memory;
  const view = new DataView(buffer, vfs);
  const found: Record<string, Uint8Array> = {};
  for (let i = 0; i < view.getInt32(0, true); ++i) {
    const name = textAt(memory, vfs + names + i * nameSize);
    const size = view.getInt32(sizes + i * 4, true);
    found[name] = new Uint8Array(buffer, view.getUint32(contents + i * 4, true), size).slice();
  }
  return found;
}
