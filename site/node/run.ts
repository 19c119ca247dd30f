/**
 * Compiles and runs programs as the page does, for the build, which proves that they print there what
 * they print natively.
 *
 *   node run.mjs CPP ENGINE [--compare-all]     answers questions on its standard streams, one by one
 *
 * CPP is the folder of this file with llvm.wasm, cpp.pack and header.pch, ENGINE that of MuJoCo for the
 * browser. Where native/ is in CPP, Debian's clang makes the objects (native-clang.ts), in the folder in
 * which this is started; of some or of all programs they are compared with the page's. A question and
 * an answer are JSON (questions.ts) behind their size as 8 bytes, as
 * generator/process/process_supervisor.h has them. The process stays between questions, since clang is
 * machine code then.
 */
import { existsSync, readFileSync, readSync, writeSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

import { Compiler } from "../browser/cpp/compiler.js";
import type { EngineBinary, EngineFactory } from "../browser/cpp/engine.js";
import { unpack } from "../browser/cpp/pack.js";
import { ComparedClang } from "./compared-clang.js";
import { nativeClang } from "./native-clang.js";
import { answer, type Question } from "./questions.js";

const [cpp, engine, option] = process.argv.slice(2) as [string, string, string?];
const compiler = await Compiler.of({
  llvm: moduleIn(cpp, "llvm.wasm"),
  engine: await engineIn(engine),
  pack: unpack(readFileSync(path.join(cpp, "cpp.pack"))),
});
compiler.useHeader(readFileSync(path.join(cpp, "header.pch")));
const comparesAll = option === "--compare-all";
const native = path.join(cpp, "native");
const clang = nativeClang(native, path.resolve("native-clang"));
if (clang) compiler.useQuickCompiler(new ComparedClang(clang, comparesAll));
else if (comparesAll && existsSync(native)) throw new Error("the native compiler cannot be used");
for (let question = read(); question !== undefined; question = read()) {
  write(JSON.stringify(await answer(compiler, JSON.parse(question) as Question)));
}

function moduleIn(folder: string, name: string): WebAssembly.Module {
  return new WebAssembly.Module(readFileSync(path.join(folder, name)));
}

async function engineIn(folder: string): Promise<EngineBinary> {
  const glue = pathToFileURL(path.resolve(folder, "engine.mjs")).href;
  const { default: factory } = (await import(glue)) as { readonly default: EngineFactory };
  return { factory, module: moduleIn(folder, "engine.wasm") };
}

/** Nothing at the end of the stream. */
function read(): string | undefined {
  const size = bytes(8);
  return size && bytes(Number(size.readBigUInt64LE()))?.toString("utf8");
}

function bytes(count: number): Buffer | undefined {
  const buffer = Buffer.alloc(count);
  for (let at = 0; at < count;) {
    const read = readSync(0, buffer, at, count - at, null);
    if (read === 0) return undefined;
    at += read;
  }
  return buffer;
}

function write(text: string): void {
  const content = Buffer.from(text);
  const size = Buffer.alloc(8);
  size.writeBigUInt64LE(BigInt(content.length));
  const all = Buffer.concat([size, content]);
  for (let at = 0; at < all.length;) at += writeSync(1, all, at);
}
