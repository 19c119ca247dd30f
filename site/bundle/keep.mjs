// Begins with what takes minutes of the compiler for the page: node site/bundle/keep.mjs PART STAMP
//
// PART is `compiler` or `pack`. It goes into the user's cache, unless it is there, and build.mjs finds it
// (cpp.mjs). STAMP then names its folder. What is missing for it, build.mjs says.

import { writeFile } from "node:fs/promises";
import path from "node:path";

import { inWorkFolder, keptCompiler, keptPack, writeCompiler } from "./cpp.mjs";

// Given the compiler.
const parts = {
  compiler: (llvm) => keptCompiler(llvm),
  pack: (llvm) => keptPack(site, llvm),
};

const site = path.resolve(import.meta.dirname, "..");
const [part, stamp] = process.argv.slice(2);
if (!parts[part] || !stamp) {
  console.error(`usage: node site/bundle/keep.mjs ${Object.keys(parts).join("|")} STAMP`);
  process.exit(2);
}
const kept = await inWorkFolder(async (work) => {
  const llvm = path.join(work, "llvm.wasm");
  await writeCompiler(site, llvm);
  return parts[part](llvm);
}).catch(() => "nothing");
await writeFile(stamp, `${kept}\n`);
