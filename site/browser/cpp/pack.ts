/**
 * Many files as one: a line of JSON with the path and size of each, and their bytes in that order.
 * bundle/cpp.mjs writes it.
 */
import { Files } from "./files.js";

export function unpack(pack: Uint8Array): Files {
  const line = pack.indexOf("\n".charCodeAt(0));
  const index = new TextDecoder().decode(pack.subarray(0, line));
  const files = new Files();
  let at = line + 1;
  for (const [path, size] of JSON.parse(index) as [string, number][]) {
    files.put(path, pack.subarray(at, at + size));
    at += size;
  }
  return files;
}
