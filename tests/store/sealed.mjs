// The sealed entries of a store, as generator/base/store_entry.cpp writes them.

import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { basename, dirname } from "node:path";

// As the store hashes several parts.
function hashOf(...parts) {
  const hash = createHash("sha256");
  for (const part of parts.map((one) => Buffer.from(one))) {
    hash.update(`${part.length}:`).update(part);
  }
  return hash.digest("hex");
}

// On its way, and as earlier versions wrote it on a disk, an entry does not say where it is from.
export const sealOnItsWay = (name, bytes) => `mjcourse-store 2 ${hashOf(name, bytes)}\n`;
export const sealOnDisk = (name, bytes, origin) =>
  `mjcourse-store 3 ${hashOf(name, origin, bytes)} ${origin}\n`;

// What is in the `file` of a store's folder: the entry's name, the word for its origin, its bytes.
export function readSealed(file) {
  const all = readFileSync(file);
  const end = all.indexOf("\n") + 1;
  const [bytes, seal] = [all.subarray(end), all.subarray(0, end).toString()];
  const origin = seal.trim().split(" ")[3] ?? "";
  const hash = basename(dirname(file)) + basename(file);
  const names = ["ac", "list", "here"].map((kind) => `${kind}/${hash}`);
  const name = names.find((one) => sealOnDisk(one, bytes, origin) === seal);
  if (name === undefined) throw new Error(`${file} has another seal`);
  return { name, origin, bytes };
}
