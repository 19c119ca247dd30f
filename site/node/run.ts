/**
 * Compiles and runs programs as the page does, for the build, which proves that they print there what
 * they print natively.
 *
 *   node run.mjs --prepare CPP OUT        makes the precompiled header
 *   node run.mjs CPP ENGINE PREPARED      answers questions on its standard streams, one by one
 *
 * CPP is the folder of this file with llvm.wasm and cpp.pack, ENGINE that of MuJoCo for the browser. A
 * question and an answer are JSON (questions.ts) behind their size as 8 bytes, as
 * generator/process/process_supervisor.h has them. The process stays between questions, since clang is
 * machine code then.
 */
import { readFileSync, readSync, writeFileSync, writeSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

import { Compiler } from "../browser/cpp/compiler.js";
import type { EngineBinary, EngineFactory } from "../browser/cpp/engine.js";
import type { Files } from "../browser/cpp/files.js";
import { makeHeader } from "../browser/cpp/header.js";
import { unpack } from "../browser/cpp/pack.js";
import { Respondent, type Question } from "./questions.js";

const [first, second, third] = process.argv.slice(2) as [string, string, string];
if (first === "--prepare") prepare(second, third);
else await serve(first, second, third);

function prepare(cpp: string, out: string): void {
  writeFileSync(out, makeHeader(llvmIn(cpp), packIn(cpp)));
}

async function serve(cpp: string, engine: string, prepared: string): Promise<void> {
  const compiler = await Compiler.of({
    llvm: llvmIn(cpp),
    engine: await engineIn(engine),
    pack: packIn(cpp),
  });
  compiler.useHeader(readFileSync(prepared));
  const respondent = new Respondent(compiler);
  for (let question = read(); question !== undefined; question = read()) {
    const answer = await respondent.answer(JSON.parse(question) as Question);
    write(JSON.stringify(answer));
  }
}

function llvmIn(cpp: string): WebAssembly.Module {
  return new WebAssembly.Module(readFileSync(path.join(cpp, "llvm.wasm")));
}

function packIn(cpp: string): Files {
  return unpack(readFileSync(path.join(cpp, "cpp.pack")));
}

async function engineIn(folder: string): Promise<EngineBinary> {
  const glue = pathToFileURL(path.resolve(folder, "engine.mjs")).href;
  const { default: factory } = (await import(glue)) as { readonly default: EngineFactory };
  return {
    factory,
    module: new WebAssembly.Module(readFileSync(path.join(folder, "engine.wasm"))),
  };
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
